# $state = "used"
# $compiler = "none"
installation-native = { $state ->
        [used] Compiled kernels are used.
        [off] RAYBUNDLE_NATIVE=0 switches them off: orientation and adjustment are slower, surfaces are not measured.
        *[missing] Not built: orientation and adjustment are slower, surfaces are not measured.
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
