installation-native = { $state ->
        [used] Übersetzte Kerne werden verwendet.
        [off] RAYBUNDLE_NATIVE=0 schaltet sie ab: Orientierung und Ausgleichung sind langsamer, Oberflächen werden nicht gemessen.
        *[missing] Nicht gebaut: Orientierung und Ausgleichung sind langsamer, Oberflächen werden nicht gemessen.
    }
    .do = { $state ->
            [missing] { $compiler ->
                [none] Einen C++20-Compiler installieren, dann raybundle noch einmal.
                *[other] raybundle noch einmal installieren: { $compiler } ist ein Compiler.
            }
            *[other] {""}
        }

installation-missing = FEHLT: { $how }
