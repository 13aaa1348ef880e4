# $plan_m = 0.12
# $assumed_plan_m = 0.02
# $height_m = 0.18
# $assumed_height_m = 0.03
control_sigma = The control has no standard deviations; { $plan_m } m in plan is assumed, as its points fit.
    .why = Heights have { $height_m } m; usual are { $assumed_plan_m } m in plan and { $assumed_height_m } m in height.
    .do = Give sX, sY, sZ if they are known.
