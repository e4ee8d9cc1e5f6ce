// SPDX-License-Identifier: MIT-0

// An edge of a mesh as it is seen. A block of kind outline says how wide its lines are, in pixels
// of the picture: x outside the shape that ends there, y on the surface, half on either side.
struct Edge {
    bool silhouette; // both of its faces lie on the same side of it, so that the shape ends there
    bool open;       // the surface ends there, or more than two faces meet
    float dihedral;  // radians by which the directions of its faces differ; 0: one plane
};
