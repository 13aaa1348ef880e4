# %%
import raybundle as rb

plan = rb.plan_list("turntable", "cylinder:0.3,0.4", "table", f_number=16, steps=12)
print(len(plan.design.stations), plan.expected.sigma.max())
