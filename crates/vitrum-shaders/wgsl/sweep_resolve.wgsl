struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_24 {
member: type_7,
member_1: u32,
}
struct type_25 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: type_23,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_24,
member_15: type_24,
member_16: type_24,
member_17: type_24,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_26 {
member: type_25,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_26;
@group(0) @binding(1)
var<storage> global_3: type_11;
@group(0) @binding(2)
var<storage> global_4: type_11;
@group(0) @binding(3)
var<storage> global_5: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var phi_243_: u32;
var phi_1168_: u32;
var phi_1445_: type_27;
var phi_1726_: i32;
var phi_1734_: i32;
var phi_1740_: i32;
var phi_1748_: i32;
var phi_1789_: u32;
var phi_1959_: u32;
var phi_2143_: u32;
var phi_2313_: u32;
var phi_2522_: vec3<f32>;
var phi_3124_: i32;
var phi_3127_: i32;
var phi_3129_: i32;
var phi_3131_: i32;
var phi_3146_: i32;
var phi_3152_: i32;
var phi_3125_: i32;
var phi_3128_: i32;
var phi_3130_: i32;
var phi_3132_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_3227_: i32;
var local_15: i32;
var local_16: i32;
var phi_3233_: i32;
var local_17: i32;
var phi_3240_: i32;
var local_18: i32;
var local_19: i32;
var phi_3246_: i32;
var local_20: i32;
var local_21: i32;
var phi_3257_: i32;
var local_22: i32;
var local_23: i32;
var phi_3269_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_3505_: i32;
var phi_3508_: i32;
var phi_3510_: i32;
var phi_3512_: i32;
var phi_3527_: i32;
var phi_3533_: i32;
var phi_3506_: i32;
var phi_3509_: i32;
var phi_3511_: i32;
var phi_3513_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_3608_: i32;
var local_31: i32;
var local_32: i32;
var phi_3614_: i32;
var local_33: i32;
var phi_3621_: i32;
var local_34: i32;
var local_35: i32;
var phi_3627_: i32;
var local_36: i32;
var local_37: i32;
var phi_3638_: i32;
var local_38: i32;
var local_39: i32;
var phi_3650_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_3905_: vec3<f32>;
var phi_3906_: vec3<f32>;
var phi_3907_: vec3<f32>;
let _e99 = global;
let _e110 = global_2.member.member_2;
let _e113 = global_2.member.member;
let _e121 = (_e99.x + _e110.member);
let _e123 = (_e99.y + _e110.member_1);
if (_e121 < _e110.member_2) {
if (_e123 < _e110.member_3) {
let _e126 = (_e113.member * _e113.member_1);
let _e128 = ((_e123 * _e113.member) + _e121);
let _e132 = global_2.member.member_3.member;
let _e136 = global_2.member.member_3.member_1;
let _e137 = (_e121 % 16u);
let _e138 = (_e123 % 4u);
if ((_e121 < (_e132 - (_e132 % 16u))) && (_e123 < (_e136 - (_e136 % 4u)))) {
phi_243_ = ((((_e123 - _e138) + (_e137 / 4u)) * _e132) + (((_e121 - _e137) + (_e138 * 4u)) + (_e137 % 4u)));
} else {
phi_243_ = ((_e123 * _e132) + _e121);
}
let _e159 = phi_243_;
local_10 = bitcast<i32>(_e159);
let _e162 = bitcast<i32>((_e132 * _e136));
local_11 = _e162;
let _e163 = local_11;
let _e165 = local_10;
let _e166 = ((7i * _e163) + _e165);
let _e168 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e170 = select(_e168, _e166, (_e166 < _e168));
let _e175 = global_3.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e176 = local_11;
let _e178 = local_10;
let _e179 = ((9i * _e176) + _e178);
let _e181 = select(_e168, _e179, (_e179 < _e168));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e187 = local_11;
let _e189 = local_10;
let _e190 = ((10i * _e187) + _e189);
let _e192 = select(_e168, _e190, (_e190 < _e168));
let _e197 = global_3.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e198 = local_11;
let _e200 = local_10;
let _e201 = ((11i * _e198) + _e200);
let _e203 = select(_e168, _e201, (_e201 < _e168));
let _e208 = global_3.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e209 = local_11;
let _e211 = local_10;
let _e212 = ((12i * _e209) + _e211);
let _e214 = select(_e168, _e212, (_e212 < _e168));
let _e219 = global_3.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e220 = local_11;
let _e222 = local_10;
let _e223 = ((8i * _e220) + _e222);
let _e225 = select(_e168, _e223, (_e223 < _e168));
let _e230 = global_3.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e231 = local_11;
let _e233 = local_10;
let _e234 = ((13i * _e231) + _e233);
let _e236 = select(_e168, _e234, (_e234 < _e168));
let _e241 = global_3.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e242 = local_11;
let _e244 = local_10;
let _e245 = ((14i * _e242) + _e244);
let _e247 = select(_e168, _e245, (_e245 < _e168));
let _e252 = global_3.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e253 = local_11;
let _e255 = local_10;
let _e256 = ((15i * _e253) + _e255);
let _e258 = select(_e168, _e256, (_e256 < _e168));
let _e263 = global_3.member[bitcast<u32>(select(0i, _e258, (_e258 > 0i)))];
let _e264 = local_11;
let _e266 = local_10;
let _e267 = ((3i * _e264) + _e266);
let _e269 = select(_e168, _e267, (_e267 < _e168));
let _e274 = global_3.member[bitcast<u32>(select(0i, _e269, (_e269 > 0i)))];
let _e275 = local_11;
let _e277 = local_10;
let _e278 = ((4i * _e275) + _e277);
let _e280 = select(_e168, _e278, (_e278 < _e168));
let _e285 = global_3.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e286 = local_11;
let _e288 = local_10;
let _e289 = ((5i * _e286) + _e288);
let _e291 = select(_e168, _e289, (_e289 < _e168));
let _e296 = global_3.member[bitcast<u32>(select(0i, _e291, (_e291 > 0i)))];
let _e301 = (((_e274 * _e274) + (_e285 * _e285)) + (_e296 * _e296));
let _e304 = sqrt(select(0f, _e301, (_e301 > 0f)));
let _e307 = (1f / select(1e-20f, _e304, (_e304 > 1e-20f)));
let _e308 = (_e274 * _e307);
let _e309 = (_e285 * _e307);
let _e310 = (_e296 * _e307);
let _e311 = (_e175 == 0f);
let _e312 = local_10;
let _e314 = select(_e168, _e312, (_e312 < _e168));
let _e319 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e320 = local_11;
let _e321 = local_10;
let _e322 = (_e320 + _e321);
let _e324 = select(_e168, _e322, (_e322 < _e168));
let _e329 = global_3.member[bitcast<u32>(select(0i, _e324, (_e324 > 0i)))];
let _e330 = local_11;
let _e332 = local_10;
let _e333 = ((2i * _e330) + _e332);
let _e335 = select(_e168, _e333, (_e333 < _e168));
let _e340 = global_3.member[bitcast<u32>(select(0i, _e335, (_e335 > 0i)))];
let _e344 = global_2.member.member_5.member_1;
let _e347 = select(0f, ((_e344 - _e340) / _e296), _e311);
let _e351 = (_e319 + (_e274 * _e347));
let _e352 = (_e329 + (_e285 * _e347));
let _e353 = (_e340 + (_e296 * _e347));
let _e358 = global_2.member.member_13.member.member;
let _e369 = ((((_e358.member.member * _e351) + (_e358.member.member_1 * _e352)) + (_e358.member.member_2 * _e353)) + _e358.member_1);
let _e375 = -((((_e358.member.member * _e308) + (_e358.member.member_1 * _e309)) + (_e358.member.member_2 * _e310)));
let _e377 = (_e375 > 1e-9f);
let _e381 = ((_e369 / select(1e-9f, _e375, _e377)) - 0f);
let _e384 = select(1e30f, select(0f, _e381, (_e381 > 0f)), ((_e369 > 0f) && _e377));
let _e389 = global_2.member.member_13.member_1.member;
let _e400 = ((((_e389.member.member * _e351) + (_e389.member.member_1 * _e352)) + (_e389.member.member_2 * _e353)) + _e389.member_1);
let _e406 = -((((_e389.member.member * _e308) + (_e389.member.member_1 * _e309)) + (_e389.member.member_2 * _e310)));
let _e408 = (_e406 > 1e-9f);
let _e412 = ((_e400 / select(1e-9f, _e406, _e408)) - 0f);
let _e415 = select(1e30f, select(0f, _e412, (_e412 > 0f)), ((_e400 > 0f) && _e408));
let _e419 = (_e415 < _e384);
let _e421 = select(select(-2i, -3i, _e419), -1i, ((_e384 >= 1e30f) && (_e415 >= 1e30f)));
let _e422 = select(_e384, _e415, _e419);
let _e423 = (_e421 == -3i);
let _e429 = global_2.member.member_13.member_1.member.member;
let _e434 = global_2.member.member_13.member_1.member_1;
let _e440 = global_2.member.member_13.member.member.member;
let _e445 = global_2.member.member_13.member.member_1;
let _e465 = select(_e422, 0f, (_e421 == -1i));
let _e469 = (_e351 + (_e308 * _e465));
let _e470 = (_e352 + (_e309 * _e465));
let _e471 = (_e353 + (_e310 * _e465));
let _e475 = global_2.member.member_10.member;
let _e486 = ((((_e475.member.member * _e469) + (_e475.member.member_1 * _e470)) + (_e475.member.member_2 * _e471)) + _e475.member_1);
let _e490 = global_2.member.member_10.member_1;
let _e501 = ((((_e490.member.member * _e469) + (_e490.member.member_1 * _e470)) + (_e490.member.member_2 * _e471)) + _e490.member_1);
let _e505 = global_2.member.member_10.member_2;
let _e516 = ((((_e505.member.member * _e469) + (_e505.member.member_1 * _e470)) + (_e505.member.member_2 * _e471)) + _e505.member_1);
let _e520 = global_2.member.member_10.member_3;
let _e521 = (_e520 != 0u);
let _e526 = (((_e486 * _e486) + (_e501 * _e501)) + (_e516 * _e516));
let _e529 = sqrt(select(0f, _e526, (_e526 > 0f)));
let _e532 = (1f / select(1e-20f, _e529, (_e529 > 1e-20f)));
let _e536 = select(0f, (_e486 * _e532), _e521);
let _e537 = select(0f, (_e501 * _e532), _e521);
let _e538 = select(1f, (_e516 * _e532), _e521);
let _e543 = global_2.member.member_10.member.member;
let _e554 = global_2.member.member_10.member_1.member;
let _e568 = global_2.member.member_10.member_2.member;
let _e580 = global_2.member.member_1;
let _e586 = global_2.member.member_9.member_1;
if ((_e580 & 256u) != 0u) {
let _e596 = global_2.member.member_10.member_17.member.member;
let _e597 = bitcast<i32>(_e596);
let _e603 = global_2.member.member_10.member_17.member.member_1;
let _e604 = bitcast<i32>(_e603);
let _e605 = select(1f, _e516, _e521);
let _e608 = (1f / select(1e-12f, _e605, (_e605 > 1e-12f)));
let _e613 = global_2.member.member_10.member_5;
let _e618 = global_2.member.member_10.member_8;
let _e619 = (((_e486 * _e608) - _e613) * _e618);
let _e624 = global_2.member.member_10.member_6;
let _e626 = (((_e501 * _e608) - _e624) * _e618);
let _e631 = global_2.member.member_10.member_4.member;
let _e633 = f32(bitcast<i32>(_e631));
let _e635 = select(0f, _e619, (_e619 > 0f));
let _e642 = global_2.member.member_10.member_17.member_1;
let _e645 = ((_e619 - _e633) * _e642);
let _e650 = global_2.member.member_10.member_17.member_2;
let _e652 = select(0f, _e645, (_e645 > 0f));
let _e654 = (_e650 + _e652);
let _e659 = (-(_e619) * _e642);
let _e661 = select(0f, _e659, (_e659 > 0f));
let _e663 = (_e650 + _e661);
let _e670 = (((_e650 + (select(_e633, _e635, (_e635 < _e633)) * _e642)) + (((_e652 * _e650) / select(1e-12f, _e654, (_e654 > 1e-12f))) - ((_e661 * _e650) / select(1e-12f, _e663, (_e663 > 1e-12f))))) - 0.5f);
let _e675 = global_2.member.member_10.member_4.member_1;
let _e677 = f32(bitcast<i32>(_e675));
let _e679 = select(0f, _e626, (_e626 > 0f));
let _e684 = ((_e626 - _e677) * _e642);
let _e686 = select(0f, _e684, (_e684 > 0f));
let _e688 = (_e650 + _e686);
let _e693 = (-(_e626) * _e642);
let _e695 = select(0f, _e693, (_e693 > 0f));
let _e697 = (_e650 + _e695);
let _e704 = (((_e650 + (select(_e677, _e679, (_e679 < _e677)) * _e642)) + (((_e686 * _e650) / select(1e-12f, _e688, (_e688 > 1e-12f))) - ((_e695 * _e650) / select(1e-12f, _e697, (_e697 > 1e-12f))))) - 0.5f);
let _e706 = f32((_e597 - 2i));
let _e708 = select(0f, _e670, (_e670 > 0f));
let _e710 = select(_e706, _e708, (_e708 < _e706));
let _e717 = select(0i, select(select(i32(_e710), i32(-2147483648), (_e710 < -2147483600f)), 2147483647i, (_e710 > 2147483500f)), (_e710 == _e710));
let _e721 = (_e717 - select(0i, 1i, (_e710 < f32(_e717))));
let _e723 = f32((_e604 - 2i));
let _e725 = select(0f, _e704, (_e704 > 0f));
let _e727 = select(_e723, _e725, (_e725 < _e723));
let _e734 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < -2147483600f)), 2147483647i, (_e727 > 2147483500f)), (_e727 == _e727));
let _e738 = (_e734 - select(0i, 1i, (_e727 < f32(_e734))));
let _e740 = (_e670 - f32(_e721));
let _e742 = select(0f, _e740, (_e740 > 0f));
let _e744 = select(1f, _e742, (_e742 < 1f));
let _e746 = (_e704 - f32(_e738));
let _e748 = select(0f, _e746, (_e746 > 0f));
let _e750 = select(1f, _e748, (_e748 < 1f));
if _e423 {
let _e755 = global_2.member.member_10.member_17.member_4;
phi_1168_ = _e755;
} else {
let _e760 = global_2.member.member_10.member_17.member_3;
phi_1168_ = _e760;
}
let _e762 = phi_1168_;
let _e766 = ((bitcast<i32>(_e762) + (_e738 * _e597)) + _e721);
let _e767 = (_e597 * _e604);
let _e769 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e771 = select(_e769, _e766, (_e766 < _e769));
let _e777 = global_5.member[bitcast<u32>(select(0i, _e771, (_e771 > 0i)))];
let _e778 = bitcast<f32>(_e777);
let _e779 = (_e766 + 1i);
let _e781 = select(_e769, _e779, (_e779 < _e769));
let _e787 = global_5.member[bitcast<u32>(select(0i, _e781, (_e781 > 0i)))];
let _e791 = (_e778 + ((bitcast<f32>(_e787) - _e778) * _e744));
let _e792 = (_e766 + _e597);
let _e794 = select(_e769, _e792, (_e792 < _e769));
let _e800 = global_5.member[bitcast<u32>(select(0i, _e794, (_e794 > 0i)))];
let _e801 = bitcast<f32>(_e800);
let _e802 = (_e792 + 1i);
let _e804 = select(_e769, _e802, (_e802 < _e769));
let _e810 = global_5.member[bitcast<u32>(select(0i, _e804, (_e804 > 0i)))];
let _e818 = (_e766 + _e767);
let _e820 = select(_e769, _e818, (_e818 < _e769));
let _e826 = global_5.member[bitcast<u32>(select(0i, _e820, (_e820 > 0i)))];
let _e827 = bitcast<f32>(_e826);
let _e828 = (_e818 + 1i);
let _e830 = select(_e769, _e828, (_e828 < _e769));
let _e836 = global_5.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e840 = (_e827 + ((bitcast<f32>(_e836) - _e827) * _e744));
let _e841 = (_e818 + _e597);
let _e843 = select(_e769, _e841, (_e841 < _e769));
let _e849 = global_5.member[bitcast<u32>(select(0i, _e843, (_e843 > 0i)))];
let _e850 = bitcast<f32>(_e849);
let _e851 = (_e841 + 1i);
let _e853 = select(_e769, _e851, (_e851 < _e769));
let _e859 = global_5.member[bitcast<u32>(select(0i, _e853, (_e853 > 0i)))];
let _e868 = (_e766 + (2i * _e767));
let _e870 = select(_e769, _e868, (_e868 < _e769));
let _e876 = global_5.member[bitcast<u32>(select(0i, _e870, (_e870 > 0i)))];
let _e877 = bitcast<f32>(_e876);
let _e878 = (_e868 + 1i);
let _e880 = select(_e769, _e878, (_e878 < _e769));
let _e886 = global_5.member[bitcast<u32>(select(0i, _e880, (_e880 > 0i)))];
let _e890 = (_e877 + ((bitcast<f32>(_e886) - _e877) * _e744));
let _e891 = (_e868 + _e597);
let _e893 = select(_e769, _e891, (_e891 < _e769));
let _e899 = global_5.member[bitcast<u32>(select(0i, _e893, (_e893 > 0i)))];
let _e900 = bitcast<f32>(_e899);
let _e901 = (_e891 + 1i);
let _e903 = select(_e769, _e901, (_e901 < _e769));
let _e909 = global_5.member[bitcast<u32>(select(0i, _e903, (_e903 > 0i)))];
let _e918 = (_e521 && (_e516 <= 0f));
phi_1445_ = type_27(vec3<f32>(select((_e586.member * (_e791 + (((_e801 + ((bitcast<f32>(_e810) - _e801) * _e744)) - _e791) * _e750))), _e586.member, _e918), select((_e586.member_1 * (_e840 + (((_e850 + ((bitcast<f32>(_e859) - _e850) * _e744)) - _e840) * _e750))), _e586.member_1, _e918), select((_e586.member_2 * (_e890 + (((_e900 + ((bitcast<f32>(_e909) - _e900) * _e744)) - _e890) * _e750))), _e586.member_2, _e918)), (vec3<f32>(((_e543.member * _e536) + (_e554.member * _e537)), ((_e543.member_1 * _e536) + (_e554.member_1 * _e537)), ((_e543.member_2 * _e536) + (_e554.member_2 * _e537))) + vec3<f32>((_e568.member * _e538), (_e568.member_1 * _e538), (_e568.member_2 * _e538))));
} else {
let _e930 = global_2.member.member_9.member;
phi_1445_ = type_27(vec3<f32>(_e586.member, _e586.member_1, _e586.member_2), vec3<f32>(_e930.member, _e930.member_1, _e930.member_2));
}
let _e937 = phi_1445_;
let _e946 = (((_e937.member_1.x * _e937.member_1.x) + (_e937.member_1.y * _e937.member_1.y)) + (_e937.member_1.z * _e937.member_1.z));
let _e949 = sqrt(select(0f, _e946, (_e946 > 0f)));
let _e955 = (1e-6f * _e949);
let _e959 = select((_e949 / select(_e955, _e937.member_1.z, (_e937.member_1.z > _e955))), 1f, ((_e580 & 8u) != 0u));
let _e968 = global_2.member.member_18;
let _e980 = (-((((select(_e440.member, _e429.member, _e423) * _e937.member_1.x) + (select(_e440.member_1, _e429.member_1, _e423) * _e937.member_1.y)) + (select(_e440.member_2, _e429.member_2, _e423) * _e937.member_1.z))) / select(1e-20f, _e949, (_e949 > 1e-20f)));
let _e985 = bitcast<f32>((bitcast<u32>(select(0f, _e980, (_e980 > 0f))) & 2147483647u));
let _e998 = ((_e311 || (_e175 == 3f)) && (_e421 != -1i));
let _e1003 = select(0f, (1f - _e219), _e998);
let _e1013 = (_e219 + _e1003);
let _e1018 = (1f - _e1013);
let _e1019 = local_10;
local_8 = _e1019;
local_9 = _e162;
let _e1020 = local_9;
let _e1022 = local_8;
let _e1023 = ((3i * _e1020) + _e1022);
let _e1025 = select(_e168, _e1023, (_e1023 < _e168));
let _e1030 = global_3.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1031 = local_9;
let _e1033 = local_8;
let _e1034 = ((4i * _e1031) + _e1033);
let _e1036 = select(_e168, _e1034, (_e1034 < _e168));
let _e1041 = global_3.member[bitcast<u32>(select(0i, _e1036, (_e1036 > 0i)))];
let _e1042 = local_9;
let _e1044 = local_8;
let _e1045 = ((5i * _e1042) + _e1044);
let _e1047 = select(_e168, _e1045, (_e1045 < _e168));
let _e1052 = global_3.member[bitcast<u32>(select(0i, _e1047, (_e1047 > 0i)))];
let _e1057 = (((_e1030 * _e1030) + (_e1041 * _e1041)) + (_e1052 * _e1052));
let _e1060 = sqrt(select(0f, _e1057, (_e1057 > 0f)));
let _e1063 = (1f / select(1e-20f, _e1060, (_e1060 > 1e-20f)));
let _e1064 = (_e1030 * _e1063);
let _e1065 = (_e1041 * _e1063);
let _e1066 = (_e1052 * _e1063);
let _e1070 = global_2.member.member_21.member_4;
let _e1078 = (((_e1070.member * _e1064) + (_e1070.member_1 * _e1065)) + (_e1070.member_2 * _e1066));
let _e1082 = global_2.member.member_21.member_5;
let _e1090 = (((_e1082.member * _e1064) + (_e1082.member_1 * _e1065)) + (_e1082.member_2 * _e1066));
let _e1094 = global_2.member.member_21.member_6;
let _e1102 = (((_e1094.member * _e1064) + (_e1094.member_1 * _e1065)) + (_e1094.member_2 * _e1066));
let _e1103 = bitcast<i32>(_e121);
let _e1104 = bitcast<i32>(_e123);
if (_e1103 > 0i) {
phi_1726_ = (_e1103 - 1i);
} else {
phi_1726_ = 0i;
}
let _e1110 = phi_1726_;
let _e1111 = (bitcast<i32>(_e132) - 1i);
if (_e1103 < _e1111) {
phi_1734_ = (_e1103 + 1i);
} else {
phi_1734_ = _e1111;
}
let _e1115 = phi_1734_;
if (_e1104 > 0i) {
phi_1740_ = (_e1104 - 1i);
} else {
phi_1740_ = 0i;
}
let _e1119 = phi_1740_;
let _e1120 = (bitcast<i32>(_e136) - 1i);
if (_e1104 < _e1120) {
phi_1748_ = (_e1104 + 1i);
} else {
phi_1748_ = _e1120;
}
let _e1124 = phi_1748_;
let _e1127 = global_2.member.member_3.member;
let _e1130 = global_2.member.member_3.member_1;
let _e1131 = bitcast<u32>(_e1115);
let _e1132 = bitcast<u32>(_e1104);
let _e1133 = (_e1131 % 16u);
let _e1134 = (_e1132 % 4u);
let _e1136 = (_e1127 - (_e1127 % 16u));
let _e1139 = (_e1130 - (_e1130 % 4u));
let _e1140 = (_e1132 < _e1139);
if ((_e1131 < _e1136) && _e1140) {
phi_1789_ = ((((_e1132 - _e1134) + (_e1133 / 4u)) * _e1127) + (((_e1131 - _e1133) + (_e1134 * 4u)) + (_e1133 % 4u)));
} else {
phi_1789_ = ((_e1132 * _e1127) + _e1131);
}
let _e1155 = phi_1789_;
local_6 = bitcast<i32>(_e1155);
let _e1158 = bitcast<i32>((_e1127 * _e1130));
local_7 = _e1158;
let _e1159 = local_7;
let _e1161 = local_6;
let _e1162 = ((3i * _e1159) + _e1161);
let _e1164 = select(_e168, _e1162, (_e1162 < _e168));
let _e1169 = global_3.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1170 = local_7;
let _e1172 = local_6;
let _e1173 = ((4i * _e1170) + _e1172);
let _e1175 = select(_e168, _e1173, (_e1173 < _e168));
let _e1180 = global_3.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1181 = local_7;
let _e1183 = local_6;
let _e1184 = ((5i * _e1181) + _e1183);
let _e1186 = select(_e168, _e1184, (_e1184 < _e168));
let _e1191 = global_3.member[bitcast<u32>(select(0i, _e1186, (_e1186 > 0i)))];
let _e1196 = (((_e1169 * _e1169) + (_e1180 * _e1180)) + (_e1191 * _e1191));
let _e1199 = sqrt(select(0f, _e1196, (_e1196 > 0f)));
let _e1202 = (1f / select(1e-20f, _e1199, (_e1199 > 1e-20f)));
let _e1203 = (_e1169 * _e1202);
let _e1204 = (_e1180 * _e1202);
let _e1205 = (_e1191 * _e1202);
let _e1208 = global_2.member.member_21.member_4;
let _e1219 = global_2.member.member_21.member_5;
let _e1230 = global_2.member.member_21.member_6;
let _e1239 = bitcast<u32>(_e1110);
let _e1240 = (_e1239 % 16u);
if ((_e1239 < _e1136) && _e1140) {
phi_1959_ = ((((_e1132 - _e1134) + (_e1240 / 4u)) * _e1127) + (((_e1239 - _e1240) + (_e1134 * 4u)) + (_e1240 % 4u)));
} else {
phi_1959_ = ((_e1132 * _e1127) + _e1239);
}
let _e1256 = phi_1959_;
local_4 = bitcast<i32>(_e1256);
local_5 = _e1158;
let _e1258 = local_5;
let _e1260 = local_4;
let _e1261 = ((3i * _e1258) + _e1260);
let _e1263 = select(_e168, _e1261, (_e1261 < _e168));
let _e1268 = global_3.member[bitcast<u32>(select(0i, _e1263, (_e1263 > 0i)))];
let _e1269 = local_5;
let _e1271 = local_4;
let _e1272 = ((4i * _e1269) + _e1271);
let _e1274 = select(_e168, _e1272, (_e1272 < _e168));
let _e1279 = global_3.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1280 = local_5;
let _e1282 = local_4;
let _e1283 = ((5i * _e1280) + _e1282);
let _e1285 = select(_e168, _e1283, (_e1283 < _e168));
let _e1290 = global_3.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1295 = (((_e1268 * _e1268) + (_e1279 * _e1279)) + (_e1290 * _e1290));
let _e1298 = sqrt(select(0f, _e1295, (_e1295 > 0f)));
let _e1301 = (1f / select(1e-20f, _e1298, (_e1298 > 1e-20f)));
let _e1302 = (_e1268 * _e1301);
let _e1303 = (_e1279 * _e1301);
let _e1304 = (_e1290 * _e1301);
let _e1320 = ((((_e1208.member * _e1203) + (_e1208.member_1 * _e1204)) + (_e1208.member_2 * _e1205)) - (((_e1208.member * _e1302) + (_e1208.member_1 * _e1303)) + (_e1208.member_2 * _e1304)));
let _e1321 = ((((_e1219.member * _e1203) + (_e1219.member_1 * _e1204)) + (_e1219.member_2 * _e1205)) - (((_e1219.member * _e1302) + (_e1219.member_1 * _e1303)) + (_e1219.member_2 * _e1304)));
let _e1322 = ((((_e1230.member * _e1203) + (_e1230.member_1 * _e1204)) + (_e1230.member_2 * _e1205)) - (((_e1230.member * _e1302) + (_e1230.member_1 * _e1303)) + (_e1230.member_2 * _e1304)));
let _e1327 = (((_e1320 * _e1320) + (_e1321 * _e1321)) + (_e1322 * _e1322));
let _e1331 = bitcast<u32>(_e1103);
let _e1332 = bitcast<u32>(_e1124);
let _e1333 = (_e1331 % 16u);
let _e1334 = (_e1332 % 4u);
let _e1335 = (_e1331 < _e1136);
if (_e1335 && (_e1332 < _e1139)) {
phi_2143_ = ((((_e1332 - _e1334) + (_e1333 / 4u)) * _e1127) + (((_e1331 - _e1333) + (_e1334 * 4u)) + (_e1333 % 4u)));
} else {
phi_2143_ = ((_e1332 * _e1127) + _e1331);
}
let _e1351 = phi_2143_;
local_2 = bitcast<i32>(_e1351);
local_3 = _e1158;
let _e1353 = local_3;
let _e1355 = local_2;
let _e1356 = ((3i * _e1353) + _e1355);
let _e1358 = select(_e168, _e1356, (_e1356 < _e168));
let _e1363 = global_3.member[bitcast<u32>(select(0i, _e1358, (_e1358 > 0i)))];
let _e1364 = local_3;
let _e1366 = local_2;
let _e1367 = ((4i * _e1364) + _e1366);
let _e1369 = select(_e168, _e1367, (_e1367 < _e168));
let _e1374 = global_3.member[bitcast<u32>(select(0i, _e1369, (_e1369 > 0i)))];
let _e1375 = local_3;
let _e1377 = local_2;
let _e1378 = ((5i * _e1375) + _e1377);
let _e1380 = select(_e168, _e1378, (_e1378 < _e168));
let _e1385 = global_3.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1390 = (((_e1363 * _e1363) + (_e1374 * _e1374)) + (_e1385 * _e1385));
let _e1393 = sqrt(select(0f, _e1390, (_e1390 > 0f)));
let _e1396 = (1f / select(1e-20f, _e1393, (_e1393 > 1e-20f)));
let _e1397 = (_e1363 * _e1396);
let _e1398 = (_e1374 * _e1396);
let _e1399 = (_e1385 * _e1396);
let _e1415 = bitcast<u32>(_e1119);
let _e1416 = (_e1415 % 4u);
if (_e1335 && (_e1415 < _e1139)) {
phi_2313_ = ((((_e1415 - _e1416) + (_e1333 / 4u)) * _e1127) + (((_e1331 - _e1333) + (_e1416 * 4u)) + (_e1333 % 4u)));
} else {
phi_2313_ = ((_e1415 * _e1127) + _e1331);
}
let _e1432 = phi_2313_;
local = bitcast<i32>(_e1432);
local_1 = _e1158;
let _e1434 = local_1;
let _e1436 = local;
let _e1437 = ((3i * _e1434) + _e1436);
let _e1439 = select(_e168, _e1437, (_e1437 < _e168));
let _e1444 = global_3.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1445 = local_1;
let _e1447 = local;
let _e1448 = ((4i * _e1445) + _e1447);
let _e1450 = select(_e168, _e1448, (_e1448 < _e168));
let _e1455 = global_3.member[bitcast<u32>(select(0i, _e1450, (_e1450 > 0i)))];
let _e1456 = local_1;
let _e1458 = local;
let _e1459 = ((5i * _e1456) + _e1458);
let _e1461 = select(_e168, _e1459, (_e1459 < _e168));
let _e1466 = global_3.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1471 = (((_e1444 * _e1444) + (_e1455 * _e1455)) + (_e1466 * _e1466));
let _e1474 = sqrt(select(0f, _e1471, (_e1471 > 0f)));
let _e1477 = (1f / select(1e-20f, _e1474, (_e1474 > 1e-20f)));
let _e1478 = (_e1444 * _e1477);
let _e1479 = (_e1455 * _e1477);
let _e1480 = (_e1466 * _e1477);
let _e1496 = ((((_e1208.member * _e1397) + (_e1208.member_1 * _e1398)) + (_e1208.member_2 * _e1399)) - (((_e1208.member * _e1478) + (_e1208.member_1 * _e1479)) + (_e1208.member_2 * _e1480)));
let _e1497 = ((((_e1219.member * _e1397) + (_e1219.member_1 * _e1398)) + (_e1219.member_2 * _e1399)) - (((_e1219.member * _e1478) + (_e1219.member_1 * _e1479)) + (_e1219.member_2 * _e1480)));
let _e1498 = ((((_e1230.member * _e1397) + (_e1230.member_1 * _e1398)) + (_e1230.member_2 * _e1399)) - (((_e1230.member * _e1478) + (_e1230.member_1 * _e1479)) + (_e1230.member_2 * _e1480)));
let _e1503 = (((_e1496 * _e1496) + (_e1497 * _e1497)) + (_e1498 * _e1498));
let _e1508 = f32((_e1115 - _e1110));
let _e1511 = (sqrt(select(0f, _e1327, (_e1327 > 0f))) / select(1f, _e1508, (_e1508 > 1f)));
let _e1513 = f32((_e1124 - _e1119));
let _e1516 = (sqrt(select(0f, _e1503, (_e1503 > 0f))) / select(1f, _e1513, (_e1513 > 1f)));
let _e1518 = select(_e1516, _e1511, (_e1511 > _e1516));
let _e1522 = global_2.member.member_21.member;
let _e1526 = global_2.member.member_21.member_7;
let _e1530 = vec3<f32>(_e1526.member, _e1526.member_1, _e1526.member_2);
let _e1534 = global_2.member.member_21.member_8;
if (_e1522 == 0u) {
phi_3907_ = _e1530;
} else {
if (_e1522 == 1u) {
let _e1541 = select(-1f, _e1102, (_e1102 > -1f));
let _e1543 = select(1f, _e1541, (_e1541 < 1f));
if (_e1543 > 0f) {
phi_2522_ = _e1530;
} else {
let _e1548 = global_2.member.member_21.member_9;
phi_2522_ = vec3<f32>(_e1548.member, _e1548.member_1, _e1548.member_2);
}
let _e1554 = phi_2522_;
let _e1563 = bitcast<f32>((bitcast<u32>(_e1543) & 2147483647u));
let _e1566 = sqrt(select(0f, _e1563, (_e1563 > 0f)));
phi_3906_ = vec3<f32>((_e1534.member + ((_e1554.x - _e1534.member) * _e1566)), (_e1534.member_1 + ((_e1554.y - _e1534.member_1) * _e1566)), (_e1534.member_2 + ((_e1554.z - _e1534.member_2) * _e1566)));
} else {
if (_e1522 == 2u) {
let _e1578 = global_2.member.member_21.member_10;
let _e1579 = (_e1518 / _e1578);
let _e1581 = select(1e-4f, _e1579, (_e1579 > 1e-4f));
let _e1584 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
let _e1587 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
let _e1591 = select(_e1587, _e1584, (_e1584 > _e1587));
let _e1594 = (select(_e1587, _e1584, (_e1584 < _e1587)) / select(1.1754944e-38f, _e1591, (_e1591 > 1.1754944e-38f)));
let _e1595 = (_e1594 > 0.41421357f);
let _e1599 = select(_e1594, ((_e1594 - 1f) / (_e1594 + 1f)), _e1595);
let _e1600 = (_e1599 * _e1599);
let _e1615 = (select(0f, 0.7853982f, _e1595) + (_e1599 + ((_e1599 * _e1600) * (-0.33333334f + (_e1600 * (0.2f + (_e1600 * (-0.14285713f + (_e1600 * (0.11111111f + (_e1600 * (-0.09090909f + (_e1600 * 0.0585f)))))))))))));
let _e1618 = select(_e1615, (1.5707964f - _e1615), (_e1587 > _e1584));
let _e1621 = select(_e1618, (3.1415927f - _e1618), (_e1078 < 0f));
let _e1627 = (1f - (_e1102 * _e1102));
let _e1630 = sqrt(select(0f, _e1627, (_e1627 > 0f)));
let _e1633 = (_e1581 / select(1e-3f, _e1630, (_e1630 > 1e-3f)));
let _e1634 = ((select(_e1621, -(_e1621), (_e1090 < 0f)) / _e1578) * 0.5f);
let _e1636 = select(-8e6f, _e1634, (_e1634 > -8e6f));
let _e1638 = select(8e6f, _e1636, (_e1636 < 8e6f));
let _e1645 = select(0i, select(select(i32(_e1638), i32(-2147483648), (_e1638 < -2147483600f)), 2147483647i, (_e1638 > 2147483500f)), (_e1638 == _e1638));
let _e1652 = ((_e1634 - f32((_e1645 - select(0i, 1i, (_e1638 < f32(_e1645)))))) * 2f);
let _e1660 = ((select(select((_e1652 - 2f), (1f - _e1652), (_e1652 < 1.5f)), _e1652, (_e1652 < 0.5f)) * 2f) / _e1633);
let _e1662 = select(-1f, _e1660, (_e1660 > -1f));
let _e1665 = (2f - _e1633);
let _e1667 = select(0f, _e1665, (_e1665 > 0f));
let _e1672 = select(-1f, _e1102, (_e1102 > -1f));
let _e1674 = select(1f, _e1672, (_e1672 < 1f));
let _e1677 = ((1f - _e1674) * (1f + _e1674));
let _e1680 = sqrt(select(0f, _e1677, (_e1677 > 0f)));
let _e1683 = bitcast<f32>((bitcast<u32>(_e1680) & 2147483647u));
let _e1686 = bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u));
let _e1690 = select(_e1686, _e1683, (_e1683 > _e1686));
let _e1693 = (select(_e1686, _e1683, (_e1683 < _e1686)) / select(1.1754944e-38f, _e1690, (_e1690 > 1.1754944e-38f)));
let _e1694 = (_e1693 > 0.41421357f);
let _e1698 = select(_e1693, ((_e1693 - 1f) / (_e1693 + 1f)), _e1694);
let _e1699 = (_e1698 * _e1698);
let _e1714 = (select(0f, 0.7853982f, _e1694) + (_e1698 + ((_e1698 * _e1699) * (-0.33333334f + (_e1699 * (0.2f + (_e1699 * (-0.14285713f + (_e1699 * (0.11111111f + (_e1699 * (-0.09090909f + (_e1699 * 0.0585f)))))))))))));
let _e1717 = select(_e1714, (1.5707964f - _e1714), (_e1686 > _e1683));
let _e1720 = select(_e1717, (3.1415927f - _e1717), (_e1680 < 0f));
let _e1725 = ((select(_e1720, -(_e1720), (_e1674 < 0f)) / _e1578) * 0.5f);
let _e1727 = select(-8e6f, _e1725, (_e1725 > -8e6f));
let _e1729 = select(8e6f, _e1727, (_e1727 < 8e6f));
let _e1736 = select(0i, select(select(i32(_e1729), i32(-2147483648), (_e1729 < -2147483600f)), 2147483647i, (_e1729 > 2147483500f)), (_e1729 == _e1729));
let _e1743 = ((_e1725 - f32((_e1736 - select(0i, 1i, (_e1729 < f32(_e1736)))))) * 2f);
let _e1751 = ((select(select((_e1743 - 2f), (1f - _e1743), (_e1743 < 1.5f)), _e1743, (_e1743 < 0.5f)) * 2f) / _e1581);
let _e1753 = select(-1f, _e1751, (_e1751 > -1f));
let _e1756 = (2f - _e1581);
let _e1758 = select(0f, _e1756, (_e1756 > 0f));
let _e1764 = (0.5f + ((0.5f * (select(1f, _e1662, (_e1662 < 1f)) * select(1f, _e1667, (_e1667 < 1f)))) * (select(1f, _e1753, (_e1753 < 1f)) * select(1f, _e1758, (_e1758 < 1f)))));
phi_3905_ = vec3<f32>((_e1526.member + ((_e1534.member - _e1526.member) * _e1764)), (_e1526.member_1 + ((_e1534.member_1 - _e1526.member_1) * _e1764)), (_e1526.member_2 + ((_e1534.member_2 - _e1526.member_2) * _e1764)));
} else {
let _e1778 = global_2.member.member_21.member_1;
let _e1779 = bitcast<i32>(_e1778);
let _e1784 = global_2.member.member_21.member_3;
let _e1786 = f32(bitcast<i32>(_e1784));
let _e1788 = (2f * 3.1415927f);
let _e1789 = ((_e1518 * f32(_e1779)) / _e1788);
let _e1791 = select(1e-6f, _e1789, (_e1789 > 1e-6f));
let _e1794 = bitcast<u32>(select(1.1754944e-38f, _e1791, (_e1791 > 1.1754944e-38f)));
let _e1795 = (_e1794 & 8388607u);
let _e1797 = select(0u, 1u, (_e1795 > 3474675u));
let _e1808 = bitcast<f32>((_e1795 | ((127u - _e1797) << bitcast<u32>(23i))));
let _e1811 = ((_e1808 - 1f) / (_e1808 + 1f));
let _e1812 = (_e1811 * _e1811);
let _e1827 = (f32(((bitcast<i32>((_e1794 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1797))) + (((2f * _e1811) + ((_e1811 * _e1812) * (0.6666667f + (_e1812 * (0.4f + (_e1812 * (0.2857143f + (_e1812 * (0.22222222f + (_e1812 * 0.18181819f)))))))))) * 1.442695f));
let _e1828 = (_e1786 - 1f);
let _e1830 = select(0f, _e1827, (_e1827 > 0f));
let _e1832 = select(_e1828, _e1830, (_e1830 < _e1828));
let _e1833 = (_e1786 - 2f);
let _e1835 = select(0f, _e1833, (_e1833 > 0f));
let _e1837 = select(0f, _e1832, (_e1832 > 0f));
let _e1839 = select(_e1835, _e1837, (_e1837 < _e1835));
let _e1846 = select(0i, select(select(i32(_e1839), i32(-2147483648), (_e1839 < -2147483600f)), 2147483647i, (_e1839 > 2147483500f)), (_e1839 == _e1839));
let _e1850 = (_e1846 - select(0i, 1i, (_e1839 < f32(_e1846))));
let _e1853 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
let _e1856 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
let _e1860 = select(_e1856, _e1853, (_e1853 > _e1856));
let _e1863 = (select(_e1856, _e1853, (_e1853 < _e1856)) / select(1.1754944e-38f, _e1860, (_e1860 > 1.1754944e-38f)));
let _e1864 = (_e1863 > 0.41421357f);
let _e1868 = select(_e1863, ((_e1863 - 1f) / (_e1863 + 1f)), _e1864);
let _e1869 = (_e1868 * _e1868);
let _e1884 = (select(0f, 0.7853982f, _e1864) + (_e1868 + ((_e1868 * _e1869) * (-0.33333334f + (_e1869 * (0.2f + (_e1869 * (-0.14285713f + (_e1869 * (0.11111111f + (_e1869 * (-0.09090909f + (_e1869 * 0.0585f)))))))))))));
let _e1887 = select(_e1884, (1.5707964f - _e1884), (_e1856 > _e1853));
let _e1890 = select(_e1887, (3.1415927f - _e1887), (_e1090 < 0f));
let _e1895 = (0.5f - (select(_e1890, -(_e1890), (_e1078 < 0f)) / _e1788));
let _e1897 = select(-1f, _e1102, (_e1102 > -1f));
let _e1899 = select(1f, _e1897, (_e1897 < 1f));
let _e1902 = ((1f - _e1899) * (1f + _e1899));
let _e1905 = sqrt(select(0f, _e1902, (_e1902 > 0f)));
let _e1908 = bitcast<f32>((bitcast<u32>(_e1905) & 2147483647u));
let _e1911 = bitcast<f32>((bitcast<u32>(_e1899) & 2147483647u));
let _e1915 = select(_e1911, _e1908, (_e1908 > _e1911));
let _e1918 = (select(_e1911, _e1908, (_e1908 < _e1911)) / select(1.1754944e-38f, _e1915, (_e1915 > 1.1754944e-38f)));
let _e1919 = (_e1918 > 0.41421357f);
let _e1923 = select(_e1918, ((_e1918 - 1f) / (_e1918 + 1f)), _e1919);
let _e1924 = (_e1923 * _e1923);
let _e1939 = (select(0f, 0.7853982f, _e1919) + (_e1923 + ((_e1923 * _e1924) * (-0.33333334f + (_e1924 * (0.2f + (_e1924 * (-0.14285713f + (_e1924 * (0.11111111f + (_e1924 * (-0.09090909f + (_e1924 * 0.0585f)))))))))))));
let _e1942 = select(_e1939, (1.5707964f - _e1939), (_e1911 > _e1908));
let _e1945 = select(_e1942, (3.1415927f - _e1942), (_e1905 < 0f));
let _e1950 = (0.5f - (select(_e1945, -(_e1945), (_e1899 < 0f)) / 3.1415927f));
let _e1954 = global_2.member.member_21.member_2;
let _e1955 = bitcast<i32>(_e1954);
phi_3124_ = 0i;
phi_3127_ = 0i;
phi_3129_ = _e1955;
phi_3131_ = _e1779;
loop {
let _e1957 = phi_3124_;
let _e1959 = phi_3127_;
let _e1961 = phi_3129_;
let _e1963 = phi_3131_;
local_12 = _e1963;
local_13 = _e1961;
local_14 = _e1963;
local_15 = _e1963;
local_16 = _e1963;
local_17 = _e1963;
local_18 = _e1963;
local_19 = _e1963;
local_20 = _e1961;
local_21 = _e1961;
local_22 = _e1961;
local_23 = _e1961;
local_24 = _e1963;
local_25 = _e1959;
local_26 = _e1963;
local_27 = _e1959;
let _e1964 = (_e1957 < _e1850);
if _e1964 {
if (_e1963 > 1i) {
phi_3146_ = (_e1963 >> bitcast<u32>(1i));
} else {
phi_3146_ = 1i;
}
let _e1971 = phi_3146_;
if (_e1961 > 1i) {
phi_3152_ = (_e1961 >> bitcast<u32>(1i));
} else {
phi_3152_ = 1i;
}
let _e1976 = phi_3152_;
phi_3125_ = (_e1957 + 1i);
phi_3128_ = (_e1959 + (_e1963 * _e1961));
phi_3130_ = _e1976;
phi_3132_ = _e1971;
} else {
phi_3125_ = i32();
phi_3128_ = i32();
phi_3130_ = i32();
phi_3132_ = i32();
}
let _e1979 = phi_3125_;
let _e1981 = phi_3128_;
let _e1983 = phi_3130_;
let _e1985 = phi_3132_;
continue;
continuing {
phi_3124_ = _e1979;
phi_3127_ = _e1981;
phi_3129_ = _e1983;
phi_3131_ = _e1985;
break if !(_e1964);
}
}
let _e1988 = local_12;
let _e1989 = f32(_e1988);
let _e1991 = ((_e1895 * _e1989) - 0.5f);
let _e1993 = local_13;
let _e1994 = f32(_e1993);
let _e1996 = ((_e1950 * _e1994) - 0.5f);
let _e1998 = select(-1f, _e1991, (_e1991 > -1f));
let _e2000 = select(_e1989, _e1998, (_e1998 < _e1989));
let _e2007 = select(0i, select(select(i32(_e2000), i32(-2147483648), (_e2000 < -2147483600f)), 2147483647i, (_e2000 > 2147483500f)), (_e2000 == _e2000));
let _e2011 = (_e2007 - select(0i, 1i, (_e2000 < f32(_e2007))));
let _e2013 = select(-1f, _e1996, (_e1996 > -1f));
let _e2015 = select(_e1994, _e2013, (_e2013 < _e1994));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2028 = (_e1991 - f32(_e2011));
let _e2030 = (_e1996 - f32(_e2026));
let _e2032 = select(0f, _e2030, (_e2030 > 0f));
let _e2034 = select(1f, _e2032, (_e2032 < 1f));
if (_e2011 < 0i) {
let _e2037 = local_14;
phi_3227_ = (_e2011 + _e2037);
} else {
phi_3227_ = _e2011;
}
let _e2040 = phi_3227_;
let _e2042 = local_15;
if (_e2040 >= _e2042) {
let _e2045 = local_16;
phi_3233_ = (_e2040 - _e2045);
} else {
phi_3233_ = _e2040;
}
let _e2048 = phi_3233_;
let _e2049 = (_e2011 + 1i);
if (_e2049 < 0i) {
let _e2052 = local_17;
phi_3240_ = (_e2049 + _e2052);
} else {
phi_3240_ = _e2049;
}
let _e2055 = phi_3240_;
let _e2057 = local_18;
if (_e2055 >= _e2057) {
let _e2060 = local_19;
phi_3246_ = (_e2055 - _e2060);
} else {
phi_3246_ = _e2055;
}
let _e2063 = phi_3246_;
let _e2065 = select(_e2026, 0i, (_e2026 < 0i));
let _e2067 = local_20;
if (_e2065 >= _e2067) {
let _e2070 = local_21;
phi_3257_ = (_e2070 - 1i);
} else {
phi_3257_ = _e2065;
}
let _e2073 = phi_3257_;
let _e2074 = (_e2026 + 1i);
let _e2076 = select(_e2074, 0i, (_e2074 < 0i));
let _e2078 = local_22;
if (_e2076 >= _e2078) {
let _e2081 = local_23;
phi_3269_ = (_e2081 - 1i);
} else {
phi_3269_ = _e2076;
}
let _e2084 = phi_3269_;
let _e2086 = local_24;
let _e2089 = local_25;
let _e2090 = (_e2089 + (_e2073 * _e2086));
let _e2092 = local_26;
let _e2095 = local_27;
let _e2096 = (_e2095 + (_e2084 * _e2092));
let _e2098 = (3i * (_e2090 + _e2048));
let _e2100 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e2102 = select(_e2100, _e2098, (_e2098 < _e2100));
let _e2108 = global_4.member[bitcast<u32>(select(0i, _e2102, (_e2102 > 0i)))];
let _e2109 = (_e2098 + 1i);
let _e2111 = select(_e2100, _e2109, (_e2109 < _e2100));
let _e2117 = global_4.member[bitcast<u32>(select(0i, _e2111, (_e2111 > 0i)))];
let _e2118 = (_e2098 + 2i);
let _e2120 = select(_e2100, _e2118, (_e2118 < _e2100));
let _e2126 = global_4.member[bitcast<u32>(select(0i, _e2120, (_e2120 > 0i)))];
let _e2128 = (3i * (_e2090 + _e2063));
let _e2130 = select(_e2100, _e2128, (_e2128 < _e2100));
let _e2136 = global_4.member[bitcast<u32>(select(0i, _e2130, (_e2130 > 0i)))];
let _e2137 = (_e2128 + 1i);
let _e2139 = select(_e2100, _e2137, (_e2137 < _e2100));
let _e2145 = global_4.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2146 = (_e2128 + 2i);
let _e2148 = select(_e2100, _e2146, (_e2146 < _e2100));
let _e2154 = global_4.member[bitcast<u32>(select(0i, _e2148, (_e2148 > 0i)))];
let _e2156 = (3i * (_e2096 + _e2048));
let _e2158 = select(_e2100, _e2156, (_e2156 < _e2100));
let _e2164 = global_4.member[bitcast<u32>(select(0i, _e2158, (_e2158 > 0i)))];
let _e2165 = (_e2156 + 1i);
let _e2167 = select(_e2100, _e2165, (_e2165 < _e2100));
let _e2173 = global_4.member[bitcast<u32>(select(0i, _e2167, (_e2167 > 0i)))];
let _e2174 = (_e2156 + 2i);
let _e2176 = select(_e2100, _e2174, (_e2174 < _e2100));
let _e2182 = global_4.member[bitcast<u32>(select(0i, _e2176, (_e2176 > 0i)))];
let _e2184 = (3i * (_e2096 + _e2063));
let _e2186 = select(_e2100, _e2184, (_e2184 < _e2100));
let _e2192 = global_4.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2193 = (_e2184 + 1i);
let _e2195 = select(_e2100, _e2193, (_e2193 < _e2100));
let _e2201 = global_4.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2202 = (_e2184 + 2i);
let _e2204 = select(_e2100, _e2202, (_e2202 < _e2100));
let _e2210 = global_4.member[bitcast<u32>(select(0i, _e2204, (_e2204 > 0i)))];
let _e2217 = (_e2108 + ((_e2136 - _e2108) * _e2028));
let _e2218 = (_e2117 + ((_e2145 - _e2117) * _e2028));
let _e2219 = (_e2126 + ((_e2154 - _e2126) * _e2028));
let _e2235 = (_e2217 + (((_e2164 + ((_e2192 - _e2164) * _e2028)) - _e2217) * _e2034));
let _e2236 = (_e2218 + (((_e2173 + ((_e2201 - _e2173) * _e2028)) - _e2218) * _e2034));
let _e2237 = (_e2219 + (((_e2182 + ((_e2210 - _e2182) * _e2028)) - _e2219) * _e2034));
phi_3505_ = 0i;
phi_3508_ = 0i;
phi_3510_ = _e1955;
phi_3512_ = _e1779;
loop {
let _e2240 = phi_3505_;
let _e2242 = phi_3508_;
let _e2244 = phi_3510_;
let _e2246 = phi_3512_;
local_28 = _e2246;
local_29 = _e2244;
local_30 = _e2246;
local_31 = _e2246;
local_32 = _e2246;
local_33 = _e2246;
local_34 = _e2246;
local_35 = _e2246;
local_36 = _e2244;
local_37 = _e2244;
local_38 = _e2244;
local_39 = _e2244;
local_40 = _e2246;
local_41 = _e2242;
local_42 = _e2246;
local_43 = _e2242;
let _e2247 = (_e2240 < (_e1850 + 1i));
if _e2247 {
if (_e2246 > 1i) {
phi_3527_ = (_e2246 >> bitcast<u32>(1i));
} else {
phi_3527_ = 1i;
}
let _e2254 = phi_3527_;
if (_e2244 > 1i) {
phi_3533_ = (_e2244 >> bitcast<u32>(1i));
} else {
phi_3533_ = 1i;
}
let _e2259 = phi_3533_;
phi_3506_ = (_e2240 + 1i);
phi_3509_ = (_e2242 + (_e2246 * _e2244));
phi_3511_ = _e2259;
phi_3513_ = _e2254;
} else {
phi_3506_ = i32();
phi_3509_ = i32();
phi_3511_ = i32();
phi_3513_ = i32();
}
let _e2262 = phi_3506_;
let _e2264 = phi_3509_;
let _e2266 = phi_3511_;
let _e2268 = phi_3513_;
continue;
continuing {
phi_3505_ = _e2262;
phi_3508_ = _e2264;
phi_3510_ = _e2266;
phi_3512_ = _e2268;
break if !(_e2247);
}
}
let _e2271 = local_28;
let _e2272 = f32(_e2271);
let _e2274 = ((_e1895 * _e2272) - 0.5f);
let _e2276 = local_29;
let _e2277 = f32(_e2276);
let _e2279 = ((_e1950 * _e2277) - 0.5f);
let _e2281 = select(-1f, _e2274, (_e2274 > -1f));
let _e2283 = select(_e2272, _e2281, (_e2281 < _e2272));
let _e2290 = select(0i, select(select(i32(_e2283), i32(-2147483648), (_e2283 < -2147483600f)), 2147483647i, (_e2283 > 2147483500f)), (_e2283 == _e2283));
let _e2294 = (_e2290 - select(0i, 1i, (_e2283 < f32(_e2290))));
let _e2296 = select(-1f, _e2279, (_e2279 > -1f));
let _e2298 = select(_e2277, _e2296, (_e2296 < _e2277));
let _e2305 = select(0i, select(select(i32(_e2298), i32(-2147483648), (_e2298 < -2147483600f)), 2147483647i, (_e2298 > 2147483500f)), (_e2298 == _e2298));
let _e2309 = (_e2305 - select(0i, 1i, (_e2298 < f32(_e2305))));
let _e2311 = (_e2274 - f32(_e2294));
let _e2313 = (_e2279 - f32(_e2309));
let _e2315 = select(0f, _e2313, (_e2313 > 0f));
let _e2317 = select(1f, _e2315, (_e2315 < 1f));
if (_e2294 < 0i) {
let _e2320 = local_30;
phi_3608_ = (_e2294 + _e2320);
} else {
phi_3608_ = _e2294;
}
let _e2323 = phi_3608_;
let _e2325 = local_31;
if (_e2323 >= _e2325) {
let _e2328 = local_32;
phi_3614_ = (_e2323 - _e2328);
} else {
phi_3614_ = _e2323;
}
let _e2331 = phi_3614_;
let _e2332 = (_e2294 + 1i);
if (_e2332 < 0i) {
let _e2335 = local_33;
phi_3621_ = (_e2332 + _e2335);
} else {
phi_3621_ = _e2332;
}
let _e2338 = phi_3621_;
let _e2340 = local_34;
if (_e2338 >= _e2340) {
let _e2343 = local_35;
phi_3627_ = (_e2338 - _e2343);
} else {
phi_3627_ = _e2338;
}
let _e2346 = phi_3627_;
let _e2348 = select(_e2309, 0i, (_e2309 < 0i));
let _e2350 = local_36;
if (_e2348 >= _e2350) {
let _e2353 = local_37;
phi_3638_ = (_e2353 - 1i);
} else {
phi_3638_ = _e2348;
}
let _e2356 = phi_3638_;
let _e2357 = (_e2309 + 1i);
let _e2359 = select(_e2357, 0i, (_e2357 < 0i));
let _e2361 = local_38;
if (_e2359 >= _e2361) {
let _e2364 = local_39;
phi_3650_ = (_e2364 - 1i);
} else {
phi_3650_ = _e2359;
}
let _e2367 = phi_3650_;
let _e2369 = local_40;
let _e2372 = local_41;
let _e2373 = (_e2372 + (_e2356 * _e2369));
let _e2375 = local_42;
let _e2378 = local_43;
let _e2379 = (_e2378 + (_e2367 * _e2375));
let _e2381 = (3i * (_e2373 + _e2331));
let _e2383 = select(_e2100, _e2381, (_e2381 < _e2100));
let _e2389 = global_4.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2390 = (_e2381 + 1i);
let _e2392 = select(_e2100, _e2390, (_e2390 < _e2100));
let _e2398 = global_4.member[bitcast<u32>(select(0i, _e2392, (_e2392 > 0i)))];
let _e2399 = (_e2381 + 2i);
let _e2401 = select(_e2100, _e2399, (_e2399 < _e2100));
let _e2407 = global_4.member[bitcast<u32>(select(0i, _e2401, (_e2401 > 0i)))];
let _e2409 = (3i * (_e2373 + _e2346));
let _e2411 = select(_e2100, _e2409, (_e2409 < _e2100));
let _e2417 = global_4.member[bitcast<u32>(select(0i, _e2411, (_e2411 > 0i)))];
let _e2418 = (_e2409 + 1i);
let _e2420 = select(_e2100, _e2418, (_e2418 < _e2100));
let _e2426 = global_4.member[bitcast<u32>(select(0i, _e2420, (_e2420 > 0i)))];
let _e2427 = (_e2409 + 2i);
let _e2429 = select(_e2100, _e2427, (_e2427 < _e2100));
let _e2435 = global_4.member[bitcast<u32>(select(0i, _e2429, (_e2429 > 0i)))];
let _e2437 = (3i * (_e2379 + _e2331));
let _e2439 = select(_e2100, _e2437, (_e2437 < _e2100));
let _e2445 = global_4.member[bitcast<u32>(select(0i, _e2439, (_e2439 > 0i)))];
let _e2446 = (_e2437 + 1i);
let _e2448 = select(_e2100, _e2446, (_e2446 < _e2100));
let _e2454 = global_4.member[bitcast<u32>(select(0i, _e2448, (_e2448 > 0i)))];
let _e2455 = (_e2437 + 2i);
let _e2457 = select(_e2100, _e2455, (_e2455 < _e2100));
let _e2463 = global_4.member[bitcast<u32>(select(0i, _e2457, (_e2457 > 0i)))];
let _e2465 = (3i * (_e2379 + _e2346));
let _e2467 = select(_e2100, _e2465, (_e2465 < _e2100));
let _e2473 = global_4.member[bitcast<u32>(select(0i, _e2467, (_e2467 > 0i)))];
let _e2474 = (_e2465 + 1i);
let _e2476 = select(_e2100, _e2474, (_e2474 < _e2100));
let _e2482 = global_4.member[bitcast<u32>(select(0i, _e2476, (_e2476 > 0i)))];
let _e2483 = (_e2465 + 2i);
let _e2485 = select(_e2100, _e2483, (_e2483 < _e2100));
let _e2491 = global_4.member[bitcast<u32>(select(0i, _e2485, (_e2485 > 0i)))];
let _e2498 = (_e2389 + ((_e2417 - _e2389) * _e2311));
let _e2499 = (_e2398 + ((_e2426 - _e2398) * _e2311));
let _e2500 = (_e2407 + ((_e2435 - _e2407) * _e2311));
let _e2523 = (_e1832 - f32(_e1850));
let _e2525 = select(0f, _e2523, (_e2523 > 0f));
let _e2527 = select(1f, _e2525, (_e2525 < 1f));
let _e2537 = global_2.member.member_21.member_11;
phi_3905_ = vec3<f32>(((_e2235 + (((_e2498 + (((_e2445 + ((_e2473 - _e2445) * _e2311)) - _e2498) * _e2317)) - _e2235) * _e2527)) * _e2537), ((_e2236 + (((_e2499 + (((_e2454 + ((_e2482 - _e2454) * _e2311)) - _e2499) * _e2317)) - _e2236) * _e2527)) * _e2537), ((_e2237 + (((_e2500 + (((_e2463 + ((_e2491 - _e2463) * _e2311)) - _e2500) * _e2317)) - _e2237) * _e2527)) * _e2537));
}
let _e2543 = phi_3905_;
phi_3906_ = _e2543;
}
let _e2545 = phi_3906_;
phi_3907_ = _e2545;
}
let _e2547 = phi_3907_;
let _e2551 = global_2.member.member_21.member_12;
let _e2558 = (_e1018 * _e2551);
let _e2570 = (1f - ((_e1018 * ((_e241 + _e252) + _e263)) * (1f / 3f)));
global_1.member[_e128] = ((_e186 + ((_e241 * (select(_e445.member, _e434.member, _e423) * (((_e937.member.x * _e959) * _e985) + _e968.member))) * _e1003)) + ((_e241 * _e2547.x) * _e2558));
global_1.member[(_e126 + _e128)] = ((_e197 + ((_e252 * (select(_e445.member_1, _e434.member_1, _e423) * (((_e937.member.y * _e959) * _e985) + _e968.member_1))) * _e1003)) + ((_e252 * _e2547.y) * _e2558));
global_1.member[((2u * _e126) + _e128)] = ((_e208 + ((_e263 * (select(_e445.member_2, _e434.member_2, _e423) * (((_e937.member.z * _e959) * _e985) + _e968.member_2))) * _e1003)) + ((_e263 * _e2547.z) * _e2558));
global_1.member[((3u * _e126) + _e128)] = (_e2570 + ((1f - _e2570) * _e2551));
global_1.member[((4u * _e126) + _e128)] = _e1013;
global_1.member[((5u * _e126) + _e128)] = _e241;
global_1.member[((6u * _e126) + _e128)] = _e252;
global_1.member[((7u * _e126) + _e128)] = _e263;
global_1.member[((8u * _e126) + _e128)] = ((_e230 + (_e1003 * (_e353 + (_e310 * _e422)))) / select(1e-12f, _e1013, (_e1013 > 1e-12f)));
global_1.member[((9u * _e126) + _e128)] = _e308;
global_1.member[((10u * _e126) + _e128)] = _e309;
global_1.member[((11u * _e126) + _e128)] = -(_e310);
global_1.member[((12u * _e126) + _e128)] = select(_e351, _e469, _e998);
global_1.member[((13u * _e126) + _e128)] = select(_e352, _e470, _e998);
global_1.member[((14u * _e126) + _e128)] = -(select(_e353, _e471, _e998));
global_1.member[((15u * _e126) + _e128)] = select(select(_e175, 2f, (_e175 == 4f)), 1f, _e998);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
