// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file PointPeers.h
 * @brief What point methods are compared with: CGAL, if the build has found it.
 */

#ifndef PointPeers_h
#define PointPeers_h

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

/// None without CGAL.
std::vector<std::string> PointPeerNames();

/// The most threads that peers can use: without TBB, CGAL works on one.
int PointPeerThreads();

/**
 * One iteration with the neighbours of PointFilter.h on a copy of the points with their normals,
 * which is made here and not part of the work. Empty if there is no such peer.
 */
std::function<void()> PointPeer(const std::string& name, vtkPolyData* cloud, int threads);

#endif
