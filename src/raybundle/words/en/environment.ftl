# $chosen = "sse9"
# $known = ["0", "avx2"]
environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } is unknown.
    .do = Set one of { $known }, or unset the variable.

environment-native_missing = The compiled kernels are missing.
    .why = Surfaces are measured by compiled code only.
    .do = Install a wheel of raybundle, or a C++ compiler and install again; unset RAYBUNDLE_NATIVE=0.
