// Concepts: what a type must have to be used with the library. Read by Doxygen alone.

/*! \defgroup PkgMeridianConcepts Concepts
 *  What a type must have to be used with the library, each with a model of it. */

/*!
 * \ingroup PkgMeridianConcepts
 *
 * a triangle mesh that functions read: a model of CGAL's `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
 * whose faces are triangles, whose edges have one or two faces, and whose vertices have one fan of faces each. Points
 * are read from the named parameter `vertex_point_map` or from `get(CGAL::vertex_point, tm)`. Vertices, edges and
 * faces are numbered in the order of `vertices(tm)` and so on.
 *
 * Models: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, `CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper`'s
 * type, OpenMesh's meshes through CGAL's adaptor.
 */
class ReadableTriangleMesh
{};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * a `ReadableTriangleMesh` that can be refined where it stands: a model of CGAL's `MutableFaceGraph` too. Of that
 * concept `add_vertex()`, `add_edge()`, `add_face()`, `set_target()`, `set_next()`, `set_face()` and `set_halfedge()`
 * are called; nothing is ever removed. New elements come behind those that there are, in the order of the ranges.
 *
 * Models: those of `ReadableTriangleMesh`.
 */
class RefinableTriangleMesh
{};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * what rates a loop that may become a meridian: a function object that is called with a `meridian::Loop_candidate`
 * and returns a `double`. The loops with the highest rates are cut first, and of equal ones the shorter; numbers that
 * are not finite come last. It is called once for each loop, in the order of the saddles.
 *
 * Models: the functions of `meridian::preference`, any lambda (`prefer_loops.cpp` is an example).
 */
class LoopPreference
{
public:
  /// \param loop the loop and its saddle
  /// \returns its rate
  double operator()(const meridian::Loop_candidate& loop) const;
};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * a way to cut handles. Wrapped in a `meridian::By_own_method` it is a `meridian::Cut_method` like those of the
 * library, whose result is recounted like theirs.
 *
 * Models: `meridian::By_contours` and all others that `meridian::Cut_method` lists.
 */
class CutMethod
{
public:
  static constexpr meridian::Choice_name names; ///< how reports call it, and what it means in a few words
  static constexpr bool cuts_edges;             ///< whether it finds a whole cut graph of edges, without links
  static constexpr bool moves_onto_edges;       ///< whether its curves can be moved onto edges one by one
  /// cuts the handles of a surface, as `meridian::Cut_job` says.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(meridian::Cut_job& job) const;
};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * what one may replace of a cut without writing a method: given by the named parameter `cut_traits`, or by
 * `meridian::with_traits()`. It is copied. No topology rests on what the functions return. All three are needed: derive
 * from `meridian::Default_cut_traits` to replace one. Methods that have no loops to prefer, no ways along edges or no
 * level lines do not ask for them.
 *
 * Three ways lead to a preference of one's own. `meridian::Meridian_options::preference`, in the method that is chosen,
 * is the shortest, and takes a lambda. Traits are for several replacements that belong together, and stay when another
 * method is chosen. A `CutMethod` is for what is no choice among level lines at all.
 *
 * A metric on edges measures ways along edges, which are all that `meridian::By_tree_cotree` cuts. Links and loops that
 * run through faces are straight there, and are measured in space: numbers on edges do not say how long they are.
 *
 * Models: `meridian::Default_cut_traits`.
 */
class CutTraits
{
public:
  /// how loops are preferred, by methods that cut level lines: see `LoopPreference`.
  /// \param loop the loop and its saddle
  /// \returns its rate
  double preference(const meridian::Loop_candidate& loop) const;
  /// how ways along edges are measured, by `meridian::By_tree_cotree`.
  /// \param s the surface
  /// \param halfedge one of its halfedges
  /// \returns how long the edge counts: finite, not negative, the same from both sides
  double edge_length(const meridian::Triangle_surface& s, meridian::Index halfedge) const;
  /// where level lines cross edges, which shows where they are not tightened.
  /// \param low, high the field at the ends of an edge
  /// \param level the value of the line, between them
  /// \returns the fraction of the way from the lower end to the higher one; what is not from 0 to 1 counts as a half
  double crossing(double low, double high, double level) const;
};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * who is told of the stages of a run, and may end it: given to functions on meshes by the named parameter `visitor`,
 * as a `std::reference_wrapper` or a pointer, so that it is not copied. A class derived from
 * `meridian::Progress_observer`.
 *
 * Models: `meridian::Progress_observer`, which hears and says nothing (`stop_a_run.cpp` is an example of another).
 */
class RunVisitor
{};

/*!
 * \ingroup PkgMeridianConcepts
 *
 * what solves sparse systems: a model of CGAL's concept `SparseLinearAlgebraWithFactorTraits_d` that can be made
 * without arguments, given by the named parameter `sparse_linear_solver`. It solves the symmetric positive definite
 * systems of fields, and the unsymmetric ones of mean-value weights; of the symmetric ones at least the lower
 * triangle is written. For each system one is made, whose `factor()` is called once and whose `linear_solver()` as
 * often as is needed.
 *
 * With `meridian::Weights::MEAN_VALUE` systems are not symmetric: a Cholesky factorization cannot solve them, and the
 * field is refused.
 *
 * Models: `CGAL::Eigen_solver_traits` of Eigen's direct solvers, and of its iterative ones with a preconditioner
 * (`own_solver.cpp` is an example). CGAL's default, without a preconditioner, has no `factor()` and is none. Compile
 * the program for the same vectors as the library: with `-march=native` in one of them alone, Eigen aligns memory in
 * two ways.
 */
class SparseSolverTraits
{};
