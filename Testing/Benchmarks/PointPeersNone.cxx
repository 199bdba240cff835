// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

// Without CGAL.

#include "PointPeers.h"

std::vector<std::string> PointPeerNames() { return {}; }

int PointPeerThreads() { return 0; }

std::function<void()> PointPeer(const std::string&, vtkPolyData*, int) { return {}; }
