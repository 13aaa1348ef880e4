rejected = { $n } von { $observations } Bildbeobachtungen wurden verworfen.

rejected-kind = { $kind ->
        [blunder] Grobe Fehler
        [blunder_not_located] Grobe Fehler in einem der Strahlen eines Punkts
        [behind_camera] Punkte hinter der Kamera
        [rays_diverge] Divergierende Strahlen
        [single_ray] Punkte mit nur einem verbliebenen Strahl
        [residual] Große Verbesserungen
       *[given] Vorgabe
     }: { $n }
