correlation-contained = Die Standardabweichungen der Punkte enthalten diese Korrelation; sie zählt, wenn die Kalibrierung für andere Aufnahmen dient.
