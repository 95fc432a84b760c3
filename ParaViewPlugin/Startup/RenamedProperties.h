// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef RenamedProperties_h
#define RenamedProperties_h

/// Reads old property names from state files, with a warning; new names take precedence. An alias in the XML would set
/// its default whenever a proxy is created.
void ReadRenamedProperties();

#endif
