litchi-feet = The heights are in feet.
    .do = Set the app to metres, and save the mission again.
