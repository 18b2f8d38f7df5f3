// Not in the seed, which calls it: longer than anything here.
#define inf 1e4
#define scene crossInBox
