// Whether vpgatherdd reads by an index in register 4. In an address, number 4 without a prefix means that there is no
// index; in a vector of addresses it is register 4. [Intel 64 manual, volume 2, 2.3.12 "Vector SIB (VSIB) Memory
// Addressing"] qemu 7.2 takes it for none and so reads the first element eight times. Exits with 0 where it is right.
#if defined(__x86_64__)
namespace {

int table[8] = {10, 11, 12, 13, 14, 15, 16, 17};
alignas(32) int index[8] = {7, 6, 5, 4, 3, 2, 1, 0};
alignas(32) int read[8];

} // namespace

int main()
{
    __asm__ volatile("vmovdqa (%1), %%ymm4\n\t"
                     "vpcmpeqd %%ymm1, %%ymm1, %%ymm1\n\t"
                     "vpgatherdd %%ymm1, (%0, %%ymm4, 4), %%ymm0\n\t"
                     "vmovdqa %%ymm0, (%2)"
                     :
                     : "r"(table), "r"(index), "r"(read)
                     : "memory", "xmm0", "xmm1", "xmm4");
    for (int i = 0; i < 8; ++i)
        if (read[i] != table[index[i]])
            return 1;
    return 0;
}
#else
int main()
{
    return 1;
}
#endif
