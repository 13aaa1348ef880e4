# $text = "asprs:2.5"
accuracy_class-no_unit = { OPTION("accuracy_class") }: class { $text } has no unit.
    .do = Give the unit of the ASPRS class, for example asprs:2.5cm,5cm.

# $text = "good"
accuracy_class-not_readable = { OPTION("accuracy_class") }: { $text } is no accuracy.
    .do = Give the RMSE in metres: 0.03, or 0.03,0.05 (plan, height), or -,0.05 (height alone), or asprs:2.5cm,5cm.
