/* polynomial_line.h - the equation along o + d t, over the numbers of the file that includes this one after it has defined
 *
 *   LINE(name)                      a name for that type
 *   LINE_NUMBER, LINE_VECTOR        a number; three, as x, y and z
 *   LINE_OF(x)                      that of a double
 *   LINE_ADD(a, b), LINE_MUL(a, b)  sum and product
 *   LINE_BY(a, c)                   the product with a double
 *
 * or over double, as line_name(), where LINE is not defined.
 *
 * Of the polynomial in t no more than the m + 1 lowest coefficients are formed: with m = 0 the value at o, with m = 1 its slope too. */
#ifndef LINE
#define LINE(name) line_##name
#define LINE_NUMBER double
#define LINE_VECTOR pov_vec3
#define LINE_OF(x) (x)
#define LINE_ADD(a, b) ((a) + (b))
#define LINE_MUL(a, b) ((a) * (b))
#define LINE_BY(a, c) ((a) * (c))
#endif

/* s = s (o + d t). */
COMMON_INLINE void LINE(times)(LINE_NUMBER *s, int m, LINE_NUMBER o, LINE_NUMBER d)
{
    for (int i = m; i > 0; i--)
        s[i] = LINE_ADD(LINE_MUL(s[i], o), LINE_MUL(s[i - 1], d));
    s[0] = LINE_MUL(s[0], o);
}

/* s += a c. */
COMMON_INLINE void LINE(add)(LINE_NUMBER *s, int m, const LINE_NUMBER *a, double c)
{
    for (int i = 0; i <= m; i++)
        s[i] = LINE_ADD(s[i], LINE_BY(a[i], c));
}

/* The powers of z along the ray, one after the other. */
COMMON_INLINE void LINE(powers)(LINE_NUMBER *power, int m, int highest, LINE_NUMBER o, LINE_NUMBER d)
{
    for (int i = 0; i <= m; i++)
        power[i] = LINE_OF(i == 0 ? 1.0 : 0.0);
    for (int k = 1; k <= highest; k++) {
        for (int i = 0; i <= m; i++)
            power[k * (m + 1) + i] = power[(k - 1) * (m + 1) + i];
        LINE(times)(power + k * (m + 1), m, o, d);
    }
}

/* Horner's scheme in x, of which each coefficient is one in y, of which each is a sum of powers of z; n is the polynomial's order. */
COMMON_INLINE void LINE(along)(const common_polynomial *p, int n, int m, LINE_VECTOR o, LINE_VECTOR d, LINE_NUMBER *power, LINE_NUMBER *out)
{
    const common_term *term = p->term;

    LINE(powers)(power, m, p->highest_z, o.z, d.z);
    for (int i = 0; i <= m; i++)
        out[i] = LINE_OF(0.0);
    for (int i = p->highest_x; i >= 0; i--) {
        const uint32_t row = (uint32_t)((n - i) * (n - i + 1) / 2 + n - i);   /* of j = 0 */
        LINE_NUMBER y[COMMON_ORDER_MAX + 1];

        if (i < p->highest_x)
            LINE(times)(out, m, o.x, d.x);
        if (p->highest[i] < 0)
            continue;
        for (int k = 0; k <= m; k++)
            y[k] = LINE_OF(0.0);
        for (int j = p->highest[i]; j >= 0; j--) {
            const common_term *end = p->term + p->first[row - (uint32_t)j + 1];

            if (j < p->highest[i])
                LINE(times)(y, m, o.y, d.y);
            for (; term < end; term++)
                LINE(add)(y, m, power + term->k * (m + 1), term->c);
        }
        LINE(add)(out, m, y, 1.0);
    }
}

#undef LINE
#undef LINE_NUMBER
#undef LINE_VECTOR
#undef LINE_OF
#undef LINE_ADD
#undef LINE_MUL
#undef LINE_BY
