# $methods = ["affine_views"]
# $pairs = 6
# $joined = 3
wide_baselines = { $joined } { $joined ->
        [one] photograph is
        *[other] photographs are
    } joined by { $pairs } pairs of further methods: { LIST($methods, most: 3) }.
    .why = The first matching left them out or in another part.
