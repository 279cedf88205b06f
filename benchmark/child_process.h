// SPDX-License-Identifier: GPL-3.0-or-later
// What a process costs.
#ifndef MERIDIAN_BENCHMARK_CHILD_PROCESS_H
#define MERIDIAN_BENCHMARK_CHILD_PROCESS_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

struct Cost
{
  double seconds = 0, wall = 0, megabytes = 0; // seconds of all cores, and as they pass
};

struct Child
{
  Cost cost;
  int status = 0; // -1 if it did not exit
};

inline Child run_child(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  std::fflush(stdout); // or the child prints it too
  const pid_t child = fork();
  if (child == 0)
  {
    work();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  const auto seconds = [](const timeval& t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  return {{seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count(), usage.ru_maxrss / 1024.},
          WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

// A program, without what it prints to the standard output.
inline Child run_program(std::vector<std::string> words)
{
  return run_child([&] {
    std::vector<char*> arguments;
    for (std::string& w : words) { arguments.push_back(w.data()); }
    arguments.push_back(nullptr);
    if (freopen("/dev/null", "w", stdout) == nullptr) { _exit(1); }
    execv(arguments.front(), arguments.data());
    _exit(127);
  });
}

#endif // MERIDIAN_BENCHMARK_CHILD_PROCESS_H
