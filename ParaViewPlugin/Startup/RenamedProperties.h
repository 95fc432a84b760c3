// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// State files of the version before, in which some properties have other names.

#ifndef RenamedProperties_h
#define RenamedProperties_h

/// Gives properties that have a new name the values that a state file has for their old one, with a warning. A value
/// for the new name takes precedence. An alias in the XML would set its own default whenever a proxy is created.
void ReadRenamedProperties();

#endif
