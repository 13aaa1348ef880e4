product-las = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } in { $system ->
        [none] den Achsen des Blocks
        *[other] { $system }
    }, in Schritten von { $step }.

product-las_without_unit = Der Maßstab ist frei: Koordinaten und Standardabweichungen haben keine Einheit, was LAS nicht angeben kann.

product-lazrs_missing = LAZ braucht lazrs, das nicht installiert ist; LAS wird unkomprimiert geschrieben.
    .do = pip install 'raybundle[las]'

product-mesh = { $vertices } Eckpunkte, { $triangles } Dreiecke; Median der Standardabweichung einer Höhe { NUM($sigma, digits: 2) } { $unit }.

product-heights = { NUM($width, decimals: 0) } x { NUM($height, decimals: 0) } Zellen von { NUM($cell, digits: 6) } { $unit }, { PERCENT($share) } % mit einer Höhe; Median der Standardabweichung { NUM($sigma, digits: 2) } { $sigma_unit }.

product-orthophoto_unseen = { $width } x { $height } px von { NUM($pixel, digits: 6) } { $unit }, keines davon sichtbar.

product-orthophoto = { $width } x { $height } px von { NUM($pixel, digits: 6) } { $unit }, davon { PERCENT($share) } % sichtbar in { $photographs } { $photographs ->
        [one] Foto
        *[other] Fotos
    }.

product-orthophoto_sigma = Standardabweichung in der Lage: Median { NUM($median, digits: 2) } { $unit }, 95 % unter { NUM($most, digits: 2) } { $unit }.
    .why = An { PERCENT($beyond) } % der Stellen ist sie größer als ein Pixel.

product-orthophoto_gaps = { PERCENT($share) } % der Zellen ihrer Höhen wurden gemessen; kleine Lücken sind geschlossen.
    .why = Jenseits davon ist kein Pixel sichtbar.
    .do = { $coarse ->
        [yes] Ein feineres { OPTION("density") } füllt eventuell einige der übrigen.
        *[no] {""}
    }

product-orthophoto_scenes = Grauwerte von Szenen werden auf 8 Bit gestreckt: Ihre Radiometrie geht verloren.
