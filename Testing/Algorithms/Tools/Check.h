// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checks of the tests that need no VTK. A failed check prints where and what, and the test goes on. A test ends
// with `return Check::Result();`.

#ifndef SeismicHorizonsCheck_h
#define SeismicHorizonsCheck_h

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace Check
{
/// How many checks failed since the last call of Result().
inline int& Failures()
{
  static int failures = 0;
  return failures;
}

/// The exit code of a test. Starts the count again, since one executable runs many tests.
inline int Result()
{
  const int failures = Failures();
  Failures() = 0;
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

inline std::ostream& Fail(const char* file, int line)
{
  ++Failures();
  return std::cerr << file << ':' << line << ": ";
}

inline bool True(bool condition, const char* text, const char* file, int line)
{
  if (!condition)
  {
    Fail(file, line) << text << " is false\n";
  }
  return condition;
}

template <typename A, typename B>
bool Equal(const A& a, const B& b, const char* text, const char* file, int line)
{
  const bool equal = a == b;
  if (!equal)
  {
    Fail(file, line) << text << ": " << a << " is not " << b << '\n';
  }
  return equal;
}

/// Checks that `call()` throws a std::exception whose message contains `expected`.
template <typename Call>
bool ThrowsWith(Call call, const std::string& expected, const char* text, const char* file, int line)
{
  try
  {
    call();
  }
  catch (const std::exception& error)
  {
    const bool found = std::string(error.what()).find(expected) != std::string::npos;
    if (!found)
    {
      Fail(file, line) << text << " throws \"" << error.what() << "\", expected \"" << expected << "\"\n";
    }
    return found;
  }
  Fail(file, line) << text << " throws nothing, expected \"" << expected << "\"\n";
  return false;
}
}

/// Each gives true when the check holds, so that a test can leave out what depends on it.
#define CHECK(condition) Check::True(static_cast<bool>(condition), #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(a, b) Check::Equal((a), (b), #a " == " #b, __FILE__, __LINE__)
#define CHECK_THROWS_WITH(expression, expected)                                                                        \
  Check::ThrowsWith([&]() { static_cast<void>(expression); }, (expected), #expression, __FILE__, __LINE__)

#endif
