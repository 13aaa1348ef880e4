# $state = "used"
# $compiler = "none"
installation-native = { $state ->
        [used] Compiled kernels are used.
        [off] RAYBUNDLE_NATIVE=0 switches them off; NumPy computes the same more slowly.
        *[missing] Not built; NumPy computes the same more slowly.
    }
    .do = { $state ->
            [missing] { $compiler ->
                [none] Install a C++20 compiler, then raybundle again.
                *[other] Install raybundle again: { $compiler } is a compiler.
            }
            *[other] {""}
        }

# $how = "pip install numpy"
installation-missing = MISSING: { $how }
