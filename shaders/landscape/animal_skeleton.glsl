// What all animals of a species share: SkeletonUniforms of render/animal_renderer.hpp.
layout(std140, binding = 2) uniform Skeleton {
  vec4 joints[12];   // hip, knee and foot: left hind, left fore, right hind, right fore
  vec4 neck_head;    // x, z of the neck's root and of the head's
  vec4 graze;        // turns of neck, head and trunk to the ground; how far the trunk sinks lying
  vec4 body;         // hip height; x, z of the tail's root; height at the shoulder
  vec4 look;         // x: spots (below 0: dark ones); y: half length, z: half width of the trunk; w: spots of the young
  vec4 winter;       // the coat of the month beside the summer's: duller, paler, times its colours, longer by (m)
} skeleton;
