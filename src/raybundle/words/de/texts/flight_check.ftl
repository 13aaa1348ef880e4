flight_check-sharpness = Schärfe der Aufnahmen
