# $chosen = "sse9"
# $known = ["0", "avx2"]
environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } is unknown.
    .do = Set one of { $known }, or unset the variable.
