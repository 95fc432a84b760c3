# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Selects all readers, as by clicks with Ctrl."""

from paraview import servermanager, simple

selection = servermanager.ProxyManager().GetSelectionModel("ActiveSources")
for source in simple.GetSources().values():
    if source.GetXMLName().endswith("Reader"):
        selection.Select(source.SMProxy, selection.SELECT)
