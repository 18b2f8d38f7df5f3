// The built-in functions that graphics drivers compute in 32 bits only, for programs whose floats have
// 64. `__sin` stands for `sin`, and so on; all other names are helpers.
//
// Drivers contract a product and a sum, take sums for associative, and put equal factors outside of
// them. So what must be exact is made of numbers with so few bits that no operation has anything to
// round: `__narrow` makes such numbers. Where the order of steps matters, `__settled` stands between
// them. No compiler can see through either.
//
// The polynomials are Chebyshev interpolations of the functions in the comments, with errors below a
// unit in the last place.

precision highp float;
precision highp int;

const float __INFINITY = intBitsToFloat(0x7f800000);
const float __NAN = intBitsToFloat(0x7fc00000);
const float __LARGEST = 1.7976931348623157e308;

// In two parts: the first of 32 bits, so that a small whole number times it is exact.
const float __LN_2_HIGH = 0.6931471803691238;
const float __LN_2_LOW = 1.9082149292705877e-10;
const float __LN_2 = 0.6931471805599453;
const float __LOG2_E = 1.4426950408889634;

// Half a turn, a quarter and an eighth with what is beyond their last bit.
const float __PI = 3.141592653589793;
const float __PI_REST = 1.2246467991473532e-16;
const float __PI_2 = 1.5707963267948966;
const float __PI_2_REST = 6.123233995736766e-17;
const float __PI_4 = 0.7853981633974483;
const float __PI_4_REST = 3.061616997868383e-17;
const float __2_PI = 0.6366197723675814;

// A quarter of a turn in parts of 22 bits, and the rest.
const float __QUARTER_1 = 1.570796012878418;
const float __QUARTER_2 = 3.139164164167596e-7;
const float __QUARTER_3 = 6.223371969669989e-14;
const float __QUARTER_4 = 2.0222659584103533e-21;
const float __QUARTER_5 = 2.9038559739793605e-28;

// The number in 24 bits.
float __narrow(float x) {
    return intBitsToFloat(floatBitsToInt(x));
}

// The number itself, or NaN for what is infinite.
float __settled(float x) {
    return abs(x) <= __LARGEST ? x : __NAN;
}

// 2^k for k from -1000 to 1000.
float __power_of_two(int k) {
    float root = intBitsToFloat(((k >> 3) + 127) << 23);
    float square = root * root;
    float fourth = square * square;
    return fourth * fourth * intBitsToFloat(((k & 7) + 127) << 23);
}

// x * 2^k, in two steps because 2^k may be out of range where the product is not.
float __scaled(float x, int k) {
    int first = k >> 1;
    return x * __power_of_two(first) * __power_of_two(k - first);
}

// Exponentials

// exp(high + low), where low is much smaller.
float __exp_of_sum(float high, float low) {
    if (high > 710.0) return __INFINITY;
    if (high < -746.0) return 0.0;
    float n = floor(high * __LOG2_E + 0.5);
    float r = __settled(high - n * __LN_2_HIGH) - (n * __LN_2_LOW - low);
    // (exp(r) - 1 - r - r^2 / 2) / r^3
    float p = 0.16666666666666669 + r * (0.041666666666666664 + r * (0.008333333333330062
        + r * (0.0013888888888886552 + r * (0.00019841269863053618
        + r * (2.4801587317144498e-5 + r * (2.7557268459997064e-6
        + r * (2.755728296954995e-7 + r * (2.510038549551032e-8
        + r * 2.0911236630261545e-9))))))));
    return __scaled(1.0 + (r + r * r * (0.5 + r * p)), int(n));
}

float __exp(float x) {
    return __exp_of_sum(x, 0.0);
}

float __exp2(float x) {
    if (x > 1025.0) return __INFINITY;
    if (x < -1080.0) return 0.0;
    float n = floor(x + 0.5);
    return __scaled(__exp_of_sum((x - n) * __LN_2, 0.0), int(n));
}

// Logarithms

// x * 2^-k, which is near one. x is positive and finite.
float __mantissa(float x, out int k) {
    int before = 0;
    // Into the range of 32 bits, and far from its ends.
    if (x > 18446744073709551616.0) {
        if (x >= 1.3407807929942597e154) { x *= 7.458340731200207e-155; before += 512; }
        if (x >= 1.157920892373162e77) { x *= 8.636168555094445e-78; before += 256; }
        if (x >= 3.4028236692093846e38) { x *= 2.938735877055719e-39; before += 128; }
        if (x >= 18446744073709551616.0) { x *= 5.421010862427522e-20; before += 64; }
    } else if (x < 5.421010862427522e-20) {
        if (x < 7.458340731200207e-155) { x *= 1.3407807929942597e154; before -= 512; }
        if (x < 7.458340731200207e-155) { x *= 1.3407807929942597e154; before -= 512; }
        if (x < 8.636168555094445e-78) { x *= 1.157920892373162e77; before -= 256; }
        if (x < 2.938735877055719e-39) { x *= 3.4028236692093846e38; before -= 128; }
        if (x < 5.421010862427522e-20) { x *= 18446744073709551616.0; before -= 64; }
    }
    // The bits are those of 32; beside the exponent there is the root of one half.
    int own = (floatBitsToInt(x) - 0x3f3504f3) >> 23;
    k = before + own;
    return x * intBitsToFloat((127 - own) << 23);
}

// (log((1 + s) / (1 - s)) - 2 s) / s^3 of s^2, for s of at most 0.172.
float __log_series(float z) {
    return 0.666666666666667 + z * (0.39999999999899444 + z * (0.2857142862600327
        + z * (0.22222211130259878 + z * (0.18182889455674947
        + z * (0.15331710618210773 + z * 0.14616585424888623)))));
}

// log(1 + f) for f from -0.293 to 0.415.
float __log_near_one(float f) {
    float s = f / (2.0 + f);
    float z = s * s;
    float h = 0.5 * f * f;
    return f - (h - s * (h + z * __log_series(z)));
}

float __log(float x) {
    if (x == 0.0) return -__INFINITY;
    if (!(x > 0.0)) return __NAN;
    if (x > __LARGEST) return x;
    int k;
    float m = __mantissa(x, k);
    float n = float(k);
    return n * __LN_2_HIGH + (__log_near_one(m - 1.0) + n * __LN_2_LOW);
}

float __log2(float x) {
    if (x == 0.0) return -__INFINITY;
    if (!(x > 0.0)) return __NAN;
    if (x > __LARGEST) return x;
    int k;
    float m = __mantissa(x, k);
    return float(k) + __log_near_one(m - 1.0) * __LOG2_E;
}

// log(1 + f) for f >= 0.
float __log_beyond_one(float f) {
    if (f < 0.41) return __log_near_one(f);
    return __log(1.0 + f);
}

// exp(y * log(x)). The logarithm and its product with y are sums of two numbers, for an exponent's error
// is the result's relative one. The specification leaves negative x undefined, and zeros of both: here
// they give NaN and 1.
float __pow(float x, float y) {
    if (y == 0.0) return 1.0;
    if (x == 0.0) return y > 0.0 ? 0.0 : __INFINITY;
    if (!(x > 0.0)) return __NAN;
    if (x > __LARGEST) return y > 0.0 ? __INFINITY : 0.0;
    // log(x) = n * log(2) + log(m), and log(m) = 2 s + s^3 * series with s = (m - 1) / (m + 1).
    int k;
    float m = __mantissa(x, k);
    float n = float(k);
    float f = m - 1.0;
    float d = m + 1.0;
    float d_high = __narrow(d);
    float d_low = m - __settled(d_high - 1.0);
    float s = f / d;
    float s_high = __narrow(s);
    float s_low = (__settled(f - s_high * d_high) - s_high * d_low) / d;
    float z = s * s;
    float small = 2.0 * s_low + (s * z * __log_series(z) + n * __LN_2_LOW);
    float whole = __settled(n * __LN_2_HIGH);
    float log_high = __narrow(whole + 2.0 * s_high + small);
    float log_low = __settled(__settled(whole - log_high) + 2.0 * s_high) + small;
    // Beyond these bounds the power is 0, 1 or infinite.
    y = clamp(y, -18446744073709551616.0, 18446744073709551616.0);
    float y_high = __narrow(y);
    float y_low = y - y_high;
    float low = y_high * log_low + y_low * (log_high + log_low);
    return __exp_of_sum(y_high * log_high, low);
}

// Hyperbolic functions

float __sinh(float x) {
    float a = abs(x);
    if (a < 1.0) {
        float z = x * x;
        // (sinh(x) - x) / x^3 of x^2
        float p = 0.16666666666666666 + z * (0.008333333333333299 + z * (0.00019841269841324198
            + z * (2.7557319191381816e-6 + z * (2.5052117695907823e-8
            + z * (1.6057679623801638e-10 + z * 7.746178593018827e-13)))));
        return x + x * z * p;
    }
    float e = __exp(min(a, 700.0));
    float result = 0.5 * (e - 1.0 / e);
    if (a > 700.0) {
        float root = __exp(0.5 * a);
        result = (0.5 * root) * root;
    }
    return x < 0.0 ? -result : result;
}

float __cosh(float x) {
    float a = abs(x);
    if (a > 700.0) {
        float root = __exp(0.5 * a);
        return (0.5 * root) * root;
    }
    float e = __exp(a);
    return 0.5 * (e + 1.0 / e);
}

float __tanh(float x) {
    float a = abs(x);
    if (a < 1.0) {
        float s = __sinh(x);
        return s / sqrt(1.0 + s * s);
    }
    float result = a < 30.0 ? 1.0 - 2.0 / (__exp(2.0 * a) + 1.0) : 1.0;
    return x < 0.0 ? -result : result;
}

float __asinh(float x) {
    float a = abs(x);
    float result;
    if (a > 1073741824.0) {
        result = __log(a) + __LN_2;
    } else {
        result = __log_beyond_one(a + a * a / (1.0 + sqrt(1.0 + a * a)));
    }
    return x < 0.0 ? -result : result;
}

float __acosh(float x) {
    if (!(x >= 1.0)) return __NAN;
    if (x > 1073741824.0) return __log(x) + __LN_2;
    float t = x - 1.0;
    return __log_beyond_one(t + sqrt(t * (x + 1.0)));
}

float __atanh(float x) {
    float a = abs(x);
    if (!(a <= 1.0)) return __NAN;
    float result = a < 1.0 ? 0.5 * __log_beyond_one(2.0 * a / (1.0 - a)) : __INFINITY;
    return x < 0.0 ? -result : result;
}

// Angles

// An angle of more than 2^30 without its whole turns. From 2^52 on, where neighbouring numbers are almost
// a radian apart, every angle counts as zero.
float __without_turns(float x) {
    if (!(abs(x) < 4503599627370496.0)) return abs(x) <= __LARGEST ? 0.0 : __NAN;
    float n = 4.0 * floor(x * (0.25 * __2_PI) + 0.5);
    // Two numbers of few bits, so that their products are exact.
    float high = __narrow(n);
    float low = n - high;
    float r = __settled(__settled(x - high * __QUARTER_1) - low * __QUARTER_1);
    r = __settled(__settled(r - high * __QUARTER_2) - low * __QUARTER_2);
    r = __settled(__settled(r - high * __QUARTER_3) - low * __QUARTER_3);
    return (r - n * __QUARTER_4) - n * __QUARTER_5;
}

// An angle without its whole quarters, of which it also has the number, modulo 4.
float __without_quarters(float x, out int quarters) {
    if (!(abs(x) <= 1073741824.0)) x = __without_turns(x);
    float n = floor(x * __2_PI + 0.5);
    quarters = int(n) & 3;
    float r = __settled(__settled(x - n * __QUARTER_1) - n * __QUARTER_2);
    return ((r - n * __QUARTER_3) - n * __QUARTER_4) - n * __QUARTER_5;
}

// sin(r) for r of at most an eighth of a turn.
float __sin_of_part(float r) {
    float z = r * r;
    // (sin(r) - r) / r^3
    float p = -0.16666666666666666 + z * (0.008333333333330948 + z * (-0.00019841269836756774
        + z * (2.7557316101617874e-6 + z * (-2.505113165023518e-8
        + z * 1.5918115263265974e-10))));
    return r + r * z * p;
}

// cos(r) for r of at most an eighth of a turn.
float __cos_of_part(float r) {
    float z = r * r;
    // (cos(r) - 1 + r^2 / 2) / r^4
    float p = 0.041666666666666664 + z * (-0.0013888888888887398 + z * (2.480158729876456e-5
        + z * (-2.7557317271145144e-7 + z * (2.087614614655861e-9
        + z * -1.1382623647474604e-11))));
    return 1.0 - (0.5 * z - z * z * p);
}

float __sin(float x) {
    int quarters;
    float r = __without_quarters(x, quarters);
    float result = (quarters & 1) == 0 ? __sin_of_part(r) : __cos_of_part(r);
    return quarters >= 2 ? -result : result;
}

float __cos(float x) {
    int quarters;
    float r = __without_quarters(x, quarters);
    float result = (quarters & 1) == 0 ? __cos_of_part(r) : __sin_of_part(r);
    return quarters == 1 || quarters == 2 ? -result : result;
}

float __tan(float x) {
    int quarters;
    float r = __without_quarters(x, quarters);
    float s = __sin_of_part(r);
    float c = __cos_of_part(r);
    return (quarters & 1) == 0 ? s / c : -c / s;
}

// atan(y / x) for y and x of at least zero, of which one is more.
float __angle(float y, float x) {
    bool is_steep = y > x;
    float low = is_steep ? x : y;
    float high = is_steep ? y : x;
    if (high > 1e300) {
        // Their sum must not be infinite.
        low = 5.421010862427522e-20 * min(low, __LARGEST);
        high = 5.421010862427522e-20 * min(high, __LARGEST);
    }
    // Beyond a sixteenth of a turn, as seen from an eighth.
    bool is_far = low > 0.41421356 * high;
    float t = is_far ? (low - high) / (low + high) : low / high;
    float z = t * t;
    // (atan(t) - t) / t^3
    float p = -0.3333333333333333 + z * (0.19999999999995516 + z * (-0.14285714284665682
        + z * (0.11111111015187018 + z * (-0.0909090457530649 + z * (0.07692183125376892
        + z * (-0.06664510525508936 + z * (0.05858140904866328 + z * (-0.050854078345894844
        + z * (0.03923044778479309 + z * -0.019175404711104935)))))))));
    float r = t + t * z * p;
    if (is_far) r = __PI_4 + (r + __PI_4_REST);
    return is_steep ? __PI_2 - (r - __PI_2_REST) : r;
}

float __atan(float x) {
    float r = __angle(abs(x), 1.0);
    return x < 0.0 ? -r : r;
}

// The specification leaves the angle of nothing undefined: here it is zero.
float __atan(float y, float x) {
    if (x == 0.0 && y == 0.0) return 0.0;
    float r = __angle(abs(y), abs(x));
    if (x < 0.0) r = __PI - (r - __PI_REST);
    return y < 0.0 ? -r : r;
}

float __asin(float x) {
    if (!(abs(x) <= 1.0)) return __NAN;
    return __atan(x, sqrt((1.0 - x) * (1.0 + x)));
}

float __acos(float x) {
    if (!(abs(x) <= 1.0)) return __NAN;
    return __atan(sqrt((1.0 - x) * (1.0 + x)), x);
}
