# %%
import raybundle as rb

plan = rb.plan_network("facade:6,4", "facade-plan", photographs=8, object_points=40, effort="quick")
print(plan.design.figure, plan.q)
