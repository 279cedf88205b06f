// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/complete_cut.h>

#include <meridian/base/Stage_runner.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/By_contours.h>
#include <meridian/cut/Cut_job.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/internal/cut_along_contours.h>
#include <meridian/cut/keep_out.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/cut/open_cut.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/pieces.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <algorithm>
#include <string>
#include <utility>

namespace meridian {

void check_seams(const Triangle_surface& root, const std::vector<Index>& seams)
{
  check_surface(root);
  const auto wrong = std::find_if(seams.begin(), seams.end(), [&](Index h) {
    return h < 0 || h >= root.number_of_halfedges() || root.opposite[h] < 0;
  });
  if (wrong != seams.end())
  {
    throw Invalid_input_error("seams are halfedges inside the surface; " + std::to_string(*wrong) + " is none");
  }
}

namespace internal {

namespace {

// Completes a cut of pieces that may have handles.
class Completion
{
public:
  Completion(const Triangle_surface& root, const Completion_options& options, Cut& cut)
    : m_root(root), m_options(options), m_cut(cut), m_run{options.observer, cut.seconds}
  {
    m_kept_out = find_kept_out(cut.surface, options.keep_out);
  }

  void run()
  {
    if (!m_kept_out.empty() && !m_options.on_edges) { cut_handles(wall_off(m_cut.surface, m_kept_out)); }
    cut_handles(m_cut.surface);
    m_run(Stage::LINKS, [&] { add_curves(m_cut, Curve_kind::LINK, link()); });
    m_cut.length_found = seam_length(m_cut.surface);
    m_run(Stage::OPEN, [&] { open_cut(m_cut); });
  }

private:
  // Cuts the handles of what is between the seams of a surface, which is that of the cut, with more seams or none.
  void cut_handles(const Refined_surface& s)
  {
    m_pieces_of = s;
    m_opened = open_along(s);
    m_meridians.clear();
    m_saddles.clear();
    for (const Surface_piece& piece : pieces_of(surface_of(m_pieces_of, m_opened)))
    {
      if (genus(piece.surface) == 0) { continue; }
      if (m_options.on_edges) { cut_edges(piece); }
      else { find_meridians_of(piece); }
    }
    m_run(Stage::INSERT, [&] {
      add_curves(m_cut, Curve_kind::MERIDIAN, insert_curves(m_root, m_cut.surface, m_meridians).vertices);
      for (std::size_t i = 0; i < m_saddles.size(); ++i)
      {
        m_cut.curves[m_cut.curves.size() - m_saddles.size() + i].saddle = m_saddles[i];
      }
    });
  }

  // Makes a piece a disc.
  void cut_edges(const Surface_piece& piece)
  {
    Refined_surface s(piece.surface);
    m_run(Stage::MERIDIANS, [&] {
      constexpr int bases = 16;
      const auto progress = [&](double done) { m_run.progress(Stage::MERIDIANS, done); };
      if (m_kept_out.empty()) { flag_seam(s, find_short_tree_cotree_cut(piece.surface, bases, progress)); }
      else
      {
        const std::vector<char> kept_out = carry_kept_out(piece, m_pieces_of, m_kept_out),
                                inside = vertices_inside(piece.surface, kept_out);
        flag_seam(s, find_short_tree_cotree_cut(piece.surface, bases, progress, longer_inside(piece.surface, kept_out),
                                                [&](Index v) { return !inside[v]; }));
      }
    });
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      if (s.seam[h]) { m_cut.surface.seam[halfedge_of_whole(piece, h)] = 1; }
    }
    std::vector<std::vector<Index>> paths = seam_paths(s);
    for (auto& path : paths)
      for (Index& v : path) { v = vertex_of_whole(piece, m_pieces_of, m_opened, v); }
    add_curves(m_cut, Curve_kind::PATH, std::move(paths));
  }

  // Edges inside what is kept out of are longer than all others together.
  static Edge_metric longer_inside(const Triangle_surface& piece, const std::vector<char>& kept_out)
  {
    double all = 0;
    for (Index h = 0; h < piece.number_of_halfedges(); ++h) { all += piece.length(h); }
    return [&kept_out, all](const Triangle_surface& s, Index h) {
      const Index o = s.opposite[h];
      const bool is_inside = o >= 0 && kept_out[s.face(h)] && kept_out[s.face(o)];
      return s.length(h) + (is_inside ? all : 0);
    };
  }

  // Finds a meridian for each handle of a piece, which keep to its inside.
  void find_meridians_of(const Surface_piece& piece)
  {
    Cut_options options;
    options.tightening = Tightening::CURVES;
    options.tighten_options = m_options.tighten_options;
    options.solvers = m_options.solvers;
    options.observer = m_options.observer;
    Cut of_piece;
    of_piece.genus = genus(piece.surface);
    Cut_job job{piece.surface, options, m_run, of_piece};
    const By_contours contours;
    Meridian_search search;
    for (Surface_curve& curve : find_cut_meridians(job, contours, contours, search))
    {
      m_meridians.push_back(carry_to_whole(piece, m_pieces_of, m_opened, std::move(curve)));
    }
    for (const Meridian_choice& c : search.choices)
    {
      m_saddles.push_back(vertex_of_whole(piece, m_pieces_of, m_opened, search.candidates[c.loop].saddle));
    }
    static_cast<Field_summary&>(m_cut) = of_piece;
  }

  std::vector<std::vector<Index>> link()
  {
    std::vector<Index> points;
    const bool is_closed = m_cut.genus == 0 && m_cut.boundary_loops == 0;
    const auto seams = std::count(m_cut.surface.seam.begin(), m_cut.surface.seam.end(), 1) / 2;
    if (is_closed && seams == 1) { points.push_back(farthest_from_seam()); } // one edge alone opens nothing
    if (is_closed && seams == 0 && !m_kept_out.empty()) { points = distant_vertices(); }
    if (m_options.on_edges) { return link_boundaries_on_edges(m_cut.surface, points, m_kept_out); }
    Link_options options;
    options.bifurcations = m_options.bifurcations;
    options.kept_out = m_kept_out;
    return link_boundaries(
      m_root, m_cut.surface, options, {}, [&](double done) { m_run.progress(Stage::LINKS, done); }, nullptr, points);
  }

  Index farthest_from_seam() const
  {
    const Refined_surface& s = m_cut.surface;
    const auto seam = std::find(s.seam.begin(), s.seam.end(), 1) - s.seam.begin();
    const Closed_model g = make_closed_model(s);
    const std::vector<double> away = edge_distances(g, edge_lengths(s, g), g.node[s.source(static_cast<Index>(seam))]);
    const std::vector<char> inside = vertices_inside(s, carry_kept_out(s, m_kept_out));
    Index farthest = s.source(static_cast<Index>(seam));
    for (Index v = 0; v < s.number_of_vertices(); ++v)
    {
      if (!inside[v] && away[g.node[v]] > away[g.node[farthest]]) { farthest = v; }
    }
    return farthest;
  }

  // Two vertices that are not inside what is kept out of.
  std::vector<Index> distant_vertices() const
  {
    const Refined_surface walled = wall_off(m_cut.surface, m_kept_out);
    const Opened_surface opened = open_along(walled);
    std::vector<Surface_piece> pieces = pieces_of(surface_of(walled, opened));
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [&](const Surface_piece& piece) { return m_kept_out[piece.faces.front()] != 0; }),
                 pieces.end());
    if (pieces.empty()) { return {}; }
    const Surface_piece& piece = *std::max_element(
      pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.faces.size() < b.faces.size(); });
    const Closed_model g = make_closed_model(piece.surface);
    const auto [from, to] = find_distant_nodes(piece.surface, g);
    return {vertex_of_whole(piece, walled, opened, g.representative[from]),
            vertex_of_whole(piece, walled, opened, g.representative[to])};
  }

  const Triangle_surface& m_root;
  const Completion_options& m_options;
  Cut& m_cut;
  const Stage_runner m_run;
  std::vector<char> m_kept_out;           // of each face of the root
  Refined_surface m_pieces_of;            // what is taken apart into pieces,
  Opened_surface m_opened;                // taken apart
  std::vector<Surface_curve> m_meridians; // on the whole surface
  std::vector<Index> m_saddles;           // of each of them
};

} // namespace

} // namespace internal

Cut complete_cut(const Triangle_surface& root, const std::vector<Index>& seams, const Completion_options& options)
{
  check_seams(root, seams);
  Cut cut;
  cut.tightening = options.on_edges ? Tightening::NONE : Tightening::CURVES;
  cut.boundary_loops = static_cast<int>(boundary_loops(root).size());
  cut.genus = genus(root);
  cut.smallest_angle_before = smallest_angle(root);
  cut.surface = Refined_surface(root);
  flag_seam(cut.surface, seams);
  add_curves(cut, Curve_kind::SEAM, seam_paths(cut.surface));
  internal::Completion(root, options, cut).run();
  return cut;
}

} // namespace meridian
