micmac-affine_frame = Ein affines Sensorsystem (OrIntGlob) wird nicht unterstützt.
    .do = Ohne dieses kalibrieren.

micmac-several_distortions = Mehrere Verzeichnungen hintereinander werden nicht unterstützt.
    .do = Mit einer Verzeichnung kalibrieren.

micmac-model_count = Verzeichnungsmodelle: { $n }; nötig ist genau eines.
    .do = Prüfen, ob die Datei vollständig ist.

micmac-radial_count = Die radiale Verzeichnung hat { $n } Koeffizienten; höchstens { $most } werden unterstützt.
    .do = Mit weniger kalibrieren.
