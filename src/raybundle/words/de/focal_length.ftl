focal_length-not_positive = Die Brennweite ist { $lengths }; sie muss positiv sein.
    .do = Den Wert berichtigen oder die Datei neu exportieren.
