rejection-reason = { $kind ->
        [blunder] grober Fehler
        [blunder_not_located] grober Fehler in einem der Strahlen des Punktes
        [behind_camera] hinter der Kamera
        [rays_diverge] Strahlen divergieren
        [single_ray] einzelner Strahl
        [residual] Verbesserung
        *[given] als verworfen gegeben
    }{ $axis ->
        [none] {""}
        *[other] : τ { NUM($tau, decimals: 2) } > { NUM($limit, decimals: 2) } in { $axis }
    }
