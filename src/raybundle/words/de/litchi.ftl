litchi-feet = Die Höhen sind in Fuß.
    .do = Die App auf Meter stellen und die Mission erneut speichern.
