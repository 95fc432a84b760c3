# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Begins a trace, as Tools > Start Trace does without its questions."""

from paraview import smtrace

smtrace.start_trace()
