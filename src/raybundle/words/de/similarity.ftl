similarity-too_few_points = Eine Ähnlichkeitstransformation braucht drei gemeinsame Punkte; gegeben: { $n }.
    .do = Mindestens drei Punkte mit Koordinaten in beiden Systemen angeben, nicht auf einer Geraden.

similarity-points_in_line = Die gemeinsamen Punkte der Ähnlichkeitstransformation liegen auf einer Geraden.
    .why = Die Drehung um diese Gerade ist nicht bestimmt.
    .do = Einen Punkt neben der Geraden ergänzen.
