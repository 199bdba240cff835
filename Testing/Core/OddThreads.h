// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file OddThreads.h
 * @brief An execution that cuts ranges where nobody expects it.
 */

#ifndef OddThreads_h
#define OddThreads_h

#include "Execution.h"

#include <thread>
#include <vector>

/// Runs loops on standard threads, in uneven ranges, the last one first, however small they are.
class OddThreads : public SurfaceDenoising::Execution
{
public:
  explicit OddThreads(std::size_t threads)
    : Threads(threads)
  {
  }

  void For(std::size_t count, const Body& body, std::size_t /*grain*/) override
  {
    std::vector<std::thread> threads;
    for (std::size_t t = this->Threads; t-- > 0;)
    {
      threads.emplace_back(
        [this, count, t, &body]
        {
          const std::size_t begin = this->Cut(count, t);
          const std::size_t end = this->Cut(count, t + 1);
          const std::size_t middle = begin + (end - begin) / 3;
          for (const auto& range : { std::make_pair(middle, end), std::make_pair(begin, middle) })
          {
            if (range.first < range.second)
            {
              body(range.first, range.second);
            }
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

private:
  /// Where part t begins: parts grow with the square of their number.
  std::size_t Cut(std::size_t count, std::size_t t) const
  {
    return count * t * t / (this->Threads * this->Threads);
  }

  std::size_t Threads;
};

#endif
