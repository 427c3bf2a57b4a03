// Loads and stores of vectors, in three consecutive columns. Hooks: see README.md.

vec3 load3(Fragment f, int column) { return vec3(load(f, column), load(f, column + 1), load(f, column + 2)); }

void store3(Fragment f, int column, vec3 v)
{
    store(f, column, v.x);
    store(f, column + 1, v.y);
    store(f, column + 2, v.z);
}
