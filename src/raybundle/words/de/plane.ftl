plane-points_in_line = Ebene { $name }: Ihre Punkte liegen auf einer Geraden.
    .why = Die Ebene kann sich um diese Gerade drehen.
    .do = Einen Punkt neben der Geraden ergänzen.
