certificate-not_positive = Kamera { $camera }: Kamerakonstante und Format müssen positiv sein.
    .do = Den Kalibrierschein korrigieren.

certificate-distortion_table = Kamera { $camera }: { $radii } Radien und { $distortions } Verzeichnungen passen nicht zusammen.
    .do = Zu jedem Radius (ab 0) eine Verzeichnung angeben.
