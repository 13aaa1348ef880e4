library_match-focal_length = EXIF-Brennweite { NUM($focal_mm, digits: 6) } mm{ $zoom ->
        [yes] , innerhalb von { NUM($low_mm, digits: 6) } bis { NUM($high_mm, digits: 6) } mm eines kalibrierten Zoomobjektivs
        *[no] {""}
    }

library_match-same = { $quantity ->
        [serial] Seriennummer
        *[lens] Objektiv
    } { $equal ->
        [yes] { $value }
        *[no] nicht verglichen: nicht für beide bekannt
    }

library_match-format = Format { $width_px } x { $height_px } px{ $whole ->
        [yes] {""}
        *[no] , als das Ganze von { $own_width_px } x { $own_height_px } px genommen
    }

library_match-focus = fokussiert auf { NUM($focus_m, digits: 6) } m, das Foto auf { NUM($own_focus_m, digits: 6) } m: c kann um { NUM($difference_px, digits: 2) } px abweichen

library_match-no_model = das EXIF des Fotos enthält kein Kameramodell

library_match-other = anderes { $quantity ->
        [make] Fabrikat
        [model] Modell
        [serial] Exemplar (Seriennummer)
        *[lens] Objektiv
    }: Kalibrierung { $value }, Foto { $own }

library_match-focal_length_unknown = { $zoom ->
        [yes] die EXIF-Brennweite des Fotos ist nicht bekannt, und die Kalibrierung ist die eines Zoomobjektivs
        *[no] die EXIF-Brennweite ist nicht für beide bekannt; eine Kalibrierung gilt nur für eine Brennweite
    }

library_match-other_focal_length = andere EXIF-Brennweite: Kalibrierung { NUM($focal_mm, digits: 6) } mm, Foto { NUM($own_focal_mm, digits: 6) } mm

library_match-digital_zoom = das Foto hat einen digitalen Zoom von { NUM($zoom, digits: 6) }: Es ist ein Ausschnitt

library_match-other_format = anderes Format: Kalibrierung { $width_px } x { $height_px } px, Foto { $own_width_px } x { $own_height_px } px, { $turned ->
        [yes] von einem Programm gedreht
        *[no] ein Ausschnitt
    }

library_match-beyond_zoom = kalibriert für { NUM($low_mm, digits: 6) } bis { NUM($high_mm, digits: 6) } mm eines Zoomobjektivs, Foto { NUM($own_focal_mm, digits: 6) } mm

library_match-focal_length_rounded = EXIF rundet die Brennweite auf { NUM($step_mm, digits: 6) } mm: c wird ab { NUM($sigma_mm, digits: 2) } mm geschätzt
