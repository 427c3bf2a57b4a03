#version 450
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Numbers { float numbers[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Squares { float squares[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x + 64 * gl_NumWorkGroups.x * gl_GlobalInvocationID.y;
    squares[i] = numbers[i] * numbers[i];
}
