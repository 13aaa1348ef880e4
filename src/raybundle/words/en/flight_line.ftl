# $n = 10
# $images = 12
flight_line-count = { $n } numbers of flight lines are given for { $images } images.
    .do = Give one for each image.

# $least = 2
flight_line-too_few_images = No flight line has { $least } images with observed positions or attitudes.
    .why = Differences within a line need that many.
    .do = Observe more images, or use absolute positions.

# $line_name = "line-2"
# $names = ["antenna-1", "antenna-2"]
flight_line-several_instruments = { $line_name }: its images were observed with several instruments ({ $names }).
    .do = Give the images of each instrument a line of their own.
