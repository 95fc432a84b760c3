# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Read by CPack before it packs. Without these programs it only remarks on that, and makes packages that depend on nothing.

foreach (tool IN ITEMS dpkg-shlibdeps file)
  find_program(${tool}_path "${tool}")
  if (NOT ${tool}_path)
    message(FATAL_ERROR "no ${tool}, expected it for the dependencies of the packages: install dpkg-dev and file")
  endif ()
endforeach ()
