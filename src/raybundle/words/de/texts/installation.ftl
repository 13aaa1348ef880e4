installation-native = { $state ->
        [used] Übersetzte Kerne werden verwendet.
        [off] RAYBUNDLE_NATIVE=0 schaltet sie ab; NumPy rechnet dasselbe langsamer.
        *[missing] Nicht gebaut; NumPy rechnet dasselbe langsamer.
    }
    .do = { $state ->
            [missing] { $compiler ->
                [none] Einen C++20-Compiler installieren, dann raybundle noch einmal.
                *[other] raybundle noch einmal installieren: { $compiler } ist ein Compiler.
            }
            *[other] {""}
        }

installation-missing = FEHLT: { $how }
