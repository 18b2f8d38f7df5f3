// Not in the seed: whether the march is refined.
#define BISECT 1
#if !BISECT
#undef raymarch
#endif
