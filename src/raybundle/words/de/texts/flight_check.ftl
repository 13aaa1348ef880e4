

flight_check-sharpness = Schärfe der Aufnahmen

flight_check-photographs = Aufnahmen: { $planned } geplant, { $taken } gemacht; { $missing } fehlen, { $beside } neben dem Plan.

flight_check-nothing_again = Keine Stelle muss erneut beflogen werden.

flight_check-gaps = Erneut zu befliegen: { $n } { $n ->
        [one] Lücke
        *[other] Lücken
    }, { NUM($area_m2, decimals: 0) } m2.

flight_check-overlap = Überdeckung (Median, kleinste; geplant { $wanted } %): längs { PERCENT($along) }, { PERCENT($along_least) } %{ $across_known ->
        [yes] , quer { PERCENT($across) }, { PERCENT($across_least) } %
        *[no] {""}
    }.

flight_check-gap = Lücke: { NUM($area_m2, decimals: 0) } m2 bei { $place }, { $seen }-mal von { $wanted }-mal gesehen.

flight_check-missing_of_line = Es fehlen: { $line_name }: { $n }.

flight_check-off_plan = Abstand vom Plan: Median { NUM($median_m, decimals: 1) } m, größter { NUM($largest_m, decimals: 1) } m.

flight_check-off_height = Höhenunterschiede: größter { NUM($largest_m, decimals: 1) } m{ $offset_m ->
        [0] {""}
        *[other] {" "}nach { NUM($offset_m, decimals: 1) } m für alle
    }.

flight_check-off_view = Blickrichtung um { NUM($median_deg, decimals: 1) } Grad verschieden (Median), höchstens { NUM($largest_deg, decimals: 1) } Grad ({ $name }).

flight_check-no_attitude = Die Aufnahmen haben keine Drehwinkel; die geplanten sind angenommen.

flight_check-motion = Bewegungsunschärfe: Median { NUM($median_px, decimals: 2) } px, größte { NUM($largest_px, decimals: 2) } px.
