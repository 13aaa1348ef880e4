scale_bar-length = Maßstabsstrecke { $start } - { $end }: Die Länge ist { $length_m } m.
    .do = Sie in Metern über 0 angeben.

scale_bar-sigma = Maßstabsstrecke { $start } - { $end }: Die Standardabweichung ist { $sigma_m } m.
    .do = Sie in Metern über 0 angeben.

scale_bar-too_few_rays = Maßstabsstrecke { $start } - { $end }: Ihre Endpunkte brauchen je zwei oder mehr Strahlen.
    .do = Sie in mehr Aufnahmen messen.

scale_bar-end_not_measured = Maßstabsstrecke { $start } - { $end }: Punkt { $point } ist in keiner Aufnahme gemessen.
    .do = Seine Bildmessungen mit { OPTION("control") } angeben oder Zielmarken mit { OPTION("target") } erkennen lassen.
