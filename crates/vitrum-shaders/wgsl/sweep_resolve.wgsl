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
struct type_15 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_17 {
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
struct type_18 {
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
struct type_19 {
member: type_5,
member_1: type_5,
}
struct type_20 {
member: type_7,
member_1: u32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_15,
member_3: type_14,
member_4: u32,
member_5: type_16,
member_6: type_17,
member_7: type_17,
member_8: type_18,
member_9: type_19,
member_10: f32,
member_11: type_16,
member_12: type_4,
member_13: type_9,
member_14: type_20,
member_15: type_20,
member_16: type_20,
member_17: type_20,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_22 {
member: type_21,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_11;
@group(0) @binding(2)
var<storage> global_3: type_11;
@group(0) @binding(3)
var<storage, read_write> global_4: type_11;
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
var phi_225_: u32;
var phi_1027_: i32;
var phi_1035_: i32;
var phi_1041_: i32;
var phi_1049_: i32;
var phi_1090_: u32;
var phi_1260_: u32;
var phi_1444_: u32;
var phi_1614_: u32;
var phi_1823_: vec3<f32>;
var phi_2425_: i32;
var phi_2428_: i32;
var phi_2430_: i32;
var phi_2432_: i32;
var phi_2447_: i32;
var phi_2453_: i32;
var phi_2426_: i32;
var phi_2429_: i32;
var phi_2431_: i32;
var phi_2433_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2528_: i32;
var local_15: i32;
var local_16: i32;
var phi_2534_: i32;
var local_17: i32;
var phi_2541_: i32;
var local_18: i32;
var local_19: i32;
var phi_2547_: i32;
var local_20: i32;
var local_21: i32;
var phi_2558_: i32;
var local_22: i32;
var local_23: i32;
var phi_2570_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_2806_: i32;
var phi_2809_: i32;
var phi_2811_: i32;
var phi_2813_: i32;
var phi_2828_: i32;
var phi_2834_: i32;
var phi_2807_: i32;
var phi_2810_: i32;
var phi_2812_: i32;
var phi_2814_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_2909_: i32;
var local_31: i32;
var local_32: i32;
var phi_2915_: i32;
var local_33: i32;
var phi_2922_: i32;
var local_34: i32;
var local_35: i32;
var phi_2928_: i32;
var local_36: i32;
var local_37: i32;
var phi_2939_: i32;
var local_38: i32;
var local_39: i32;
var phi_2951_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_3206_: vec3<f32>;
var phi_3207_: vec3<f32>;
var phi_3208_: vec3<f32>;
let _e97 = global;
let _e106 = global_1.member.member_2;
let _e109 = global_1.member.member;
let _e117 = (_e97.x + _e106.member);
let _e119 = (_e97.y + _e106.member_1);
if (_e117 < _e106.member_2) {
if (_e119 < _e106.member_3) {
let _e122 = (_e109.member * _e109.member_1);
let _e124 = ((_e119 * _e109.member) + _e117);
let _e128 = global_1.member.member_3.member;
let _e132 = global_1.member.member_3.member_1;
let _e133 = (_e117 % 16u);
let _e134 = (_e119 % 4u);
if ((_e117 < (_e128 - (_e128 % 16u))) && (_e119 < (_e132 - (_e132 % 4u)))) {
phi_225_ = ((((_e119 - _e134) + (_e133 / 4u)) * _e128) + (((_e117 - _e133) + (_e134 * 4u)) + (_e133 % 4u)));
} else {
phi_225_ = ((_e119 * _e128) + _e117);
}
let _e155 = phi_225_;
local_10 = bitcast<i32>(_e155);
let _e158 = bitcast<i32>((_e128 * _e132));
local_11 = _e158;
let _e159 = local_11;
let _e161 = local_10;
let _e162 = ((7i * _e159) + _e161);
let _e164 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e166 = select(_e164, _e162, (_e162 < _e164));
let _e171 = global_2.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e172 = local_11;
let _e174 = local_10;
let _e175 = ((9i * _e172) + _e174);
let _e177 = select(_e164, _e175, (_e175 < _e164));
let _e182 = global_2.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local_11;
let _e185 = local_10;
let _e186 = ((10i * _e183) + _e185);
let _e188 = select(_e164, _e186, (_e186 < _e164));
let _e193 = global_2.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e194 = local_11;
let _e196 = local_10;
let _e197 = ((11i * _e194) + _e196);
let _e199 = select(_e164, _e197, (_e197 < _e164));
let _e204 = global_2.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e205 = local_11;
let _e207 = local_10;
let _e208 = ((12i * _e205) + _e207);
let _e210 = select(_e164, _e208, (_e208 < _e164));
let _e215 = global_2.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e216 = local_11;
let _e218 = local_10;
let _e219 = ((8i * _e216) + _e218);
let _e221 = select(_e164, _e219, (_e219 < _e164));
let _e226 = global_2.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e227 = local_11;
let _e229 = local_10;
let _e230 = ((13i * _e227) + _e229);
let _e232 = select(_e164, _e230, (_e230 < _e164));
let _e237 = global_2.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e238 = local_11;
let _e240 = local_10;
let _e241 = ((14i * _e238) + _e240);
let _e243 = select(_e164, _e241, (_e241 < _e164));
let _e248 = global_2.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e249 = local_11;
let _e251 = local_10;
let _e252 = ((15i * _e249) + _e251);
let _e254 = select(_e164, _e252, (_e252 < _e164));
let _e259 = global_2.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e260 = local_11;
let _e262 = local_10;
let _e263 = ((3i * _e260) + _e262);
let _e265 = select(_e164, _e263, (_e263 < _e164));
let _e270 = global_2.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e271 = local_11;
let _e273 = local_10;
let _e274 = ((4i * _e271) + _e273);
let _e276 = select(_e164, _e274, (_e274 < _e164));
let _e281 = global_2.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e282 = local_11;
let _e284 = local_10;
let _e285 = ((5i * _e282) + _e284);
let _e287 = select(_e164, _e285, (_e285 < _e164));
let _e292 = global_2.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e297 = (((_e270 * _e270) + (_e281 * _e281)) + (_e292 * _e292));
let _e300 = sqrt(select(0f, _e297, (_e297 > 0f)));
let _e303 = (1f / select(1e-20f, _e300, (_e300 > 1e-20f)));
let _e304 = (_e270 * _e303);
let _e305 = (_e281 * _e303);
let _e306 = (_e292 * _e303);
let _e307 = (_e171 == 0f);
let _e308 = local_10;
let _e310 = select(_e164, _e308, (_e308 < _e164));
let _e315 = global_2.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e316 = local_11;
let _e317 = local_10;
let _e318 = (_e316 + _e317);
let _e320 = select(_e164, _e318, (_e318 < _e164));
let _e325 = global_2.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e326 = local_11;
let _e328 = local_10;
let _e329 = ((2i * _e326) + _e328);
let _e331 = select(_e164, _e329, (_e329 < _e164));
let _e336 = global_2.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e340 = global_1.member.member_5.member_1;
let _e343 = select(0f, ((_e340 - _e336) / _e292), _e307);
let _e347 = (_e315 + (_e270 * _e343));
let _e348 = (_e325 + (_e281 * _e343));
let _e349 = (_e336 + (_e292 * _e343));
let _e354 = global_1.member.member_13.member.member;
let _e365 = ((((_e354.member.member * _e347) + (_e354.member.member_1 * _e348)) + (_e354.member.member_2 * _e349)) + _e354.member_1);
let _e371 = -((((_e354.member.member * _e304) + (_e354.member.member_1 * _e305)) + (_e354.member.member_2 * _e306)));
let _e373 = (_e371 > 1e-9f);
let _e377 = ((_e365 / select(1e-9f, _e371, _e373)) - 0f);
let _e380 = select(1e30f, select(0f, _e377, (_e377 > 0f)), ((_e365 > 0f) && _e373));
let _e385 = global_1.member.member_13.member_1.member;
let _e396 = ((((_e385.member.member * _e347) + (_e385.member.member_1 * _e348)) + (_e385.member.member_2 * _e349)) + _e385.member_1);
let _e402 = -((((_e385.member.member * _e304) + (_e385.member.member_1 * _e305)) + (_e385.member.member_2 * _e306)));
let _e404 = (_e402 > 1e-9f);
let _e408 = ((_e396 / select(1e-9f, _e402, _e404)) - 0f);
let _e411 = select(1e30f, select(0f, _e408, (_e408 > 0f)), ((_e396 > 0f) && _e404));
let _e415 = (_e411 < _e380);
let _e417 = select(select(-2i, -3i, _e415), -1i, ((_e380 >= 1e30f) && (_e411 >= 1e30f)));
let _e419 = (_e417 == -3i);
let _e425 = global_1.member.member_13.member_1.member.member;
let _e430 = global_1.member.member_13.member_1.member_1;
let _e436 = global_1.member.member_13.member.member.member;
let _e441 = global_1.member.member_13.member.member_1;
let _e463 = global_1.member.member_9.member_1;
let _e470 = global_1.member.member_9.member;
let _e478 = (((_e470.member * _e470.member) + (_e470.member_1 * _e470.member_1)) + (_e470.member_2 * _e470.member_2));
let _e481 = sqrt(select(0f, _e478, (_e478 > 0f)));
let _e484 = global_1.member.member_1;
let _e487 = (1e-6f * _e481);
let _e491 = select((_e481 / select(_e487, _e470.member_2, (_e470.member_2 > _e487))), 1f, ((_e484 & 8u) != 0u));
let _e497 = global_1.member.member_18;
let _e509 = (-((((select(_e436.member, _e425.member, _e419) * _e470.member) + (select(_e436.member_1, _e425.member_1, _e419) * _e470.member_1)) + (select(_e436.member_2, _e425.member_2, _e419) * _e470.member_2))) / select(1e-20f, _e481, (_e481 > 1e-20f)));
let _e514 = bitcast<f32>((bitcast<u32>(select(0f, _e509, (_e509 > 0f))) & 2147483647u));
let _e529 = select(0f, (1f - _e215), ((_e307 || (_e171 == 3f)) && (_e417 != -1i)));
let _e539 = (_e215 + _e529);
let _e544 = (1f - _e539);
let _e545 = local_10;
local_8 = _e545;
local_9 = _e158;
let _e546 = local_9;
let _e548 = local_8;
let _e549 = ((3i * _e546) + _e548);
let _e551 = select(_e164, _e549, (_e549 < _e164));
let _e556 = global_2.member[bitcast<u32>(select(0i, _e551, (_e551 > 0i)))];
let _e557 = local_9;
let _e559 = local_8;
let _e560 = ((4i * _e557) + _e559);
let _e562 = select(_e164, _e560, (_e560 < _e164));
let _e567 = global_2.member[bitcast<u32>(select(0i, _e562, (_e562 > 0i)))];
let _e568 = local_9;
let _e570 = local_8;
let _e571 = ((5i * _e568) + _e570);
let _e573 = select(_e164, _e571, (_e571 < _e164));
let _e578 = global_2.member[bitcast<u32>(select(0i, _e573, (_e573 > 0i)))];
let _e583 = (((_e556 * _e556) + (_e567 * _e567)) + (_e578 * _e578));
let _e586 = sqrt(select(0f, _e583, (_e583 > 0f)));
let _e589 = (1f / select(1e-20f, _e586, (_e586 > 1e-20f)));
let _e590 = (_e556 * _e589);
let _e591 = (_e567 * _e589);
let _e592 = (_e578 * _e589);
let _e596 = global_1.member.member_21.member_4;
let _e604 = (((_e596.member * _e590) + (_e596.member_1 * _e591)) + (_e596.member_2 * _e592));
let _e608 = global_1.member.member_21.member_5;
let _e616 = (((_e608.member * _e590) + (_e608.member_1 * _e591)) + (_e608.member_2 * _e592));
let _e620 = global_1.member.member_21.member_6;
let _e628 = (((_e620.member * _e590) + (_e620.member_1 * _e591)) + (_e620.member_2 * _e592));
let _e629 = bitcast<i32>(_e117);
let _e630 = bitcast<i32>(_e119);
if (_e629 > 0i) {
phi_1027_ = (_e629 - 1i);
} else {
phi_1027_ = 0i;
}
let _e636 = phi_1027_;
let _e637 = (bitcast<i32>(_e128) - 1i);
if (_e629 < _e637) {
phi_1035_ = (_e629 + 1i);
} else {
phi_1035_ = _e637;
}
let _e641 = phi_1035_;
if (_e630 > 0i) {
phi_1041_ = (_e630 - 1i);
} else {
phi_1041_ = 0i;
}
let _e645 = phi_1041_;
let _e646 = (bitcast<i32>(_e132) - 1i);
if (_e630 < _e646) {
phi_1049_ = (_e630 + 1i);
} else {
phi_1049_ = _e646;
}
let _e650 = phi_1049_;
let _e653 = global_1.member.member_3.member;
let _e656 = global_1.member.member_3.member_1;
let _e657 = bitcast<u32>(_e641);
let _e658 = bitcast<u32>(_e630);
let _e659 = (_e657 % 16u);
let _e660 = (_e658 % 4u);
let _e662 = (_e653 - (_e653 % 16u));
let _e665 = (_e656 - (_e656 % 4u));
let _e666 = (_e658 < _e665);
if ((_e657 < _e662) && _e666) {
phi_1090_ = ((((_e658 - _e660) + (_e659 / 4u)) * _e653) + (((_e657 - _e659) + (_e660 * 4u)) + (_e659 % 4u)));
} else {
phi_1090_ = ((_e658 * _e653) + _e657);
}
let _e681 = phi_1090_;
local_6 = bitcast<i32>(_e681);
let _e684 = bitcast<i32>((_e653 * _e656));
local_7 = _e684;
let _e685 = local_7;
let _e687 = local_6;
let _e688 = ((3i * _e685) + _e687);
let _e690 = select(_e164, _e688, (_e688 < _e164));
let _e695 = global_2.member[bitcast<u32>(select(0i, _e690, (_e690 > 0i)))];
let _e696 = local_7;
let _e698 = local_6;
let _e699 = ((4i * _e696) + _e698);
let _e701 = select(_e164, _e699, (_e699 < _e164));
let _e706 = global_2.member[bitcast<u32>(select(0i, _e701, (_e701 > 0i)))];
let _e707 = local_7;
let _e709 = local_6;
let _e710 = ((5i * _e707) + _e709);
let _e712 = select(_e164, _e710, (_e710 < _e164));
let _e717 = global_2.member[bitcast<u32>(select(0i, _e712, (_e712 > 0i)))];
let _e722 = (((_e695 * _e695) + (_e706 * _e706)) + (_e717 * _e717));
let _e725 = sqrt(select(0f, _e722, (_e722 > 0f)));
let _e728 = (1f / select(1e-20f, _e725, (_e725 > 1e-20f)));
let _e729 = (_e695 * _e728);
let _e730 = (_e706 * _e728);
let _e731 = (_e717 * _e728);
let _e734 = global_1.member.member_21.member_4;
let _e745 = global_1.member.member_21.member_5;
let _e756 = global_1.member.member_21.member_6;
let _e765 = bitcast<u32>(_e636);
let _e766 = (_e765 % 16u);
if ((_e765 < _e662) && _e666) {
phi_1260_ = ((((_e658 - _e660) + (_e766 / 4u)) * _e653) + (((_e765 - _e766) + (_e660 * 4u)) + (_e766 % 4u)));
} else {
phi_1260_ = ((_e658 * _e653) + _e765);
}
let _e782 = phi_1260_;
local_4 = bitcast<i32>(_e782);
local_5 = _e684;
let _e784 = local_5;
let _e786 = local_4;
let _e787 = ((3i * _e784) + _e786);
let _e789 = select(_e164, _e787, (_e787 < _e164));
let _e794 = global_2.member[bitcast<u32>(select(0i, _e789, (_e789 > 0i)))];
let _e795 = local_5;
let _e797 = local_4;
let _e798 = ((4i * _e795) + _e797);
let _e800 = select(_e164, _e798, (_e798 < _e164));
let _e805 = global_2.member[bitcast<u32>(select(0i, _e800, (_e800 > 0i)))];
let _e806 = local_5;
let _e808 = local_4;
let _e809 = ((5i * _e806) + _e808);
let _e811 = select(_e164, _e809, (_e809 < _e164));
let _e816 = global_2.member[bitcast<u32>(select(0i, _e811, (_e811 > 0i)))];
let _e821 = (((_e794 * _e794) + (_e805 * _e805)) + (_e816 * _e816));
let _e824 = sqrt(select(0f, _e821, (_e821 > 0f)));
let _e827 = (1f / select(1e-20f, _e824, (_e824 > 1e-20f)));
let _e828 = (_e794 * _e827);
let _e829 = (_e805 * _e827);
let _e830 = (_e816 * _e827);
let _e846 = ((((_e734.member * _e729) + (_e734.member_1 * _e730)) + (_e734.member_2 * _e731)) - (((_e734.member * _e828) + (_e734.member_1 * _e829)) + (_e734.member_2 * _e830)));
let _e847 = ((((_e745.member * _e729) + (_e745.member_1 * _e730)) + (_e745.member_2 * _e731)) - (((_e745.member * _e828) + (_e745.member_1 * _e829)) + (_e745.member_2 * _e830)));
let _e848 = ((((_e756.member * _e729) + (_e756.member_1 * _e730)) + (_e756.member_2 * _e731)) - (((_e756.member * _e828) + (_e756.member_1 * _e829)) + (_e756.member_2 * _e830)));
let _e853 = (((_e846 * _e846) + (_e847 * _e847)) + (_e848 * _e848));
let _e857 = bitcast<u32>(_e629);
let _e858 = bitcast<u32>(_e650);
let _e859 = (_e857 % 16u);
let _e860 = (_e858 % 4u);
let _e861 = (_e857 < _e662);
if (_e861 && (_e858 < _e665)) {
phi_1444_ = ((((_e858 - _e860) + (_e859 / 4u)) * _e653) + (((_e857 - _e859) + (_e860 * 4u)) + (_e859 % 4u)));
} else {
phi_1444_ = ((_e858 * _e653) + _e857);
}
let _e877 = phi_1444_;
local_2 = bitcast<i32>(_e877);
local_3 = _e684;
let _e879 = local_3;
let _e881 = local_2;
let _e882 = ((3i * _e879) + _e881);
let _e884 = select(_e164, _e882, (_e882 < _e164));
let _e889 = global_2.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e890 = local_3;
let _e892 = local_2;
let _e893 = ((4i * _e890) + _e892);
let _e895 = select(_e164, _e893, (_e893 < _e164));
let _e900 = global_2.member[bitcast<u32>(select(0i, _e895, (_e895 > 0i)))];
let _e901 = local_3;
let _e903 = local_2;
let _e904 = ((5i * _e901) + _e903);
let _e906 = select(_e164, _e904, (_e904 < _e164));
let _e911 = global_2.member[bitcast<u32>(select(0i, _e906, (_e906 > 0i)))];
let _e916 = (((_e889 * _e889) + (_e900 * _e900)) + (_e911 * _e911));
let _e919 = sqrt(select(0f, _e916, (_e916 > 0f)));
let _e922 = (1f / select(1e-20f, _e919, (_e919 > 1e-20f)));
let _e923 = (_e889 * _e922);
let _e924 = (_e900 * _e922);
let _e925 = (_e911 * _e922);
let _e941 = bitcast<u32>(_e645);
let _e942 = (_e941 % 4u);
if (_e861 && (_e941 < _e665)) {
phi_1614_ = ((((_e941 - _e942) + (_e859 / 4u)) * _e653) + (((_e857 - _e859) + (_e942 * 4u)) + (_e859 % 4u)));
} else {
phi_1614_ = ((_e941 * _e653) + _e857);
}
let _e958 = phi_1614_;
local = bitcast<i32>(_e958);
local_1 = _e684;
let _e960 = local_1;
let _e962 = local;
let _e963 = ((3i * _e960) + _e962);
let _e965 = select(_e164, _e963, (_e963 < _e164));
let _e970 = global_2.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e971 = local_1;
let _e973 = local;
let _e974 = ((4i * _e971) + _e973);
let _e976 = select(_e164, _e974, (_e974 < _e164));
let _e981 = global_2.member[bitcast<u32>(select(0i, _e976, (_e976 > 0i)))];
let _e982 = local_1;
let _e984 = local;
let _e985 = ((5i * _e982) + _e984);
let _e987 = select(_e164, _e985, (_e985 < _e164));
let _e992 = global_2.member[bitcast<u32>(select(0i, _e987, (_e987 > 0i)))];
let _e997 = (((_e970 * _e970) + (_e981 * _e981)) + (_e992 * _e992));
let _e1000 = sqrt(select(0f, _e997, (_e997 > 0f)));
let _e1003 = (1f / select(1e-20f, _e1000, (_e1000 > 1e-20f)));
let _e1004 = (_e970 * _e1003);
let _e1005 = (_e981 * _e1003);
let _e1006 = (_e992 * _e1003);
let _e1022 = ((((_e734.member * _e923) + (_e734.member_1 * _e924)) + (_e734.member_2 * _e925)) - (((_e734.member * _e1004) + (_e734.member_1 * _e1005)) + (_e734.member_2 * _e1006)));
let _e1023 = ((((_e745.member * _e923) + (_e745.member_1 * _e924)) + (_e745.member_2 * _e925)) - (((_e745.member * _e1004) + (_e745.member_1 * _e1005)) + (_e745.member_2 * _e1006)));
let _e1024 = ((((_e756.member * _e923) + (_e756.member_1 * _e924)) + (_e756.member_2 * _e925)) - (((_e756.member * _e1004) + (_e756.member_1 * _e1005)) + (_e756.member_2 * _e1006)));
let _e1029 = (((_e1022 * _e1022) + (_e1023 * _e1023)) + (_e1024 * _e1024));
let _e1034 = f32((_e641 - _e636));
let _e1037 = (sqrt(select(0f, _e853, (_e853 > 0f))) / select(1f, _e1034, (_e1034 > 1f)));
let _e1039 = f32((_e650 - _e645));
let _e1042 = (sqrt(select(0f, _e1029, (_e1029 > 0f))) / select(1f, _e1039, (_e1039 > 1f)));
let _e1044 = select(_e1042, _e1037, (_e1037 > _e1042));
let _e1048 = global_1.member.member_21.member;
let _e1052 = global_1.member.member_21.member_7;
let _e1056 = vec3<f32>(_e1052.member, _e1052.member_1, _e1052.member_2);
let _e1060 = global_1.member.member_21.member_8;
if (_e1048 == 0u) {
phi_3208_ = _e1056;
} else {
if (_e1048 == 1u) {
let _e1067 = select(-1f, _e628, (_e628 > -1f));
let _e1069 = select(1f, _e1067, (_e1067 < 1f));
if (_e1069 > 0f) {
phi_1823_ = _e1056;
} else {
let _e1074 = global_1.member.member_21.member_9;
phi_1823_ = vec3<f32>(_e1074.member, _e1074.member_1, _e1074.member_2);
}
let _e1080 = phi_1823_;
let _e1089 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
let _e1092 = sqrt(select(0f, _e1089, (_e1089 > 0f)));
phi_3207_ = vec3<f32>((_e1060.member + ((_e1080.x - _e1060.member) * _e1092)), (_e1060.member_1 + ((_e1080.y - _e1060.member_1) * _e1092)), (_e1060.member_2 + ((_e1080.z - _e1060.member_2) * _e1092)));
} else {
if (_e1048 == 2u) {
let _e1104 = global_1.member.member_21.member_10;
let _e1105 = (_e1044 / _e1104);
let _e1107 = select(1e-4f, _e1105, (_e1105 > 1e-4f));
let _e1110 = bitcast<f32>((bitcast<u32>(_e604) & 2147483647u));
let _e1113 = bitcast<f32>((bitcast<u32>(_e616) & 2147483647u));
let _e1117 = select(_e1113, _e1110, (_e1110 > _e1113));
let _e1120 = (select(_e1113, _e1110, (_e1110 < _e1113)) / select(1.1754944e-38f, _e1117, (_e1117 > 1.1754944e-38f)));
let _e1121 = (_e1120 > 0.41421357f);
let _e1125 = select(_e1120, ((_e1120 - 1f) / (_e1120 + 1f)), _e1121);
let _e1126 = (_e1125 * _e1125);
let _e1141 = (select(0f, 0.7853982f, _e1121) + (_e1125 + ((_e1125 * _e1126) * (-0.33333334f + (_e1126 * (0.2f + (_e1126 * (-0.14285713f + (_e1126 * (0.11111111f + (_e1126 * (-0.09090909f + (_e1126 * 0.0585f)))))))))))));
let _e1144 = select(_e1141, (1.5707964f - _e1141), (_e1113 > _e1110));
let _e1147 = select(_e1144, (3.1415927f - _e1144), (_e604 < 0f));
let _e1153 = (1f - (_e628 * _e628));
let _e1156 = sqrt(select(0f, _e1153, (_e1153 > 0f)));
let _e1159 = (_e1107 / select(1e-3f, _e1156, (_e1156 > 1e-3f)));
let _e1160 = ((select(_e1147, -(_e1147), (_e616 < 0f)) / _e1104) * 0.5f);
let _e1162 = select(-8e6f, _e1160, (_e1160 > -8e6f));
let _e1164 = select(8e6f, _e1162, (_e1162 < 8e6f));
let _e1171 = select(0i, select(select(i32(_e1164), i32(-2147483648), (_e1164 < -2147483600f)), 2147483647i, (_e1164 > 2147483500f)), (_e1164 == _e1164));
let _e1178 = ((_e1160 - f32((_e1171 - select(0i, 1i, (_e1164 < f32(_e1171)))))) * 2f);
let _e1186 = ((select(select((_e1178 - 2f), (1f - _e1178), (_e1178 < 1.5f)), _e1178, (_e1178 < 0.5f)) * 2f) / _e1159);
let _e1188 = select(-1f, _e1186, (_e1186 > -1f));
let _e1191 = (2f - _e1159);
let _e1193 = select(0f, _e1191, (_e1191 > 0f));
let _e1198 = select(-1f, _e628, (_e628 > -1f));
let _e1200 = select(1f, _e1198, (_e1198 < 1f));
let _e1203 = ((1f - _e1200) * (1f + _e1200));
let _e1206 = sqrt(select(0f, _e1203, (_e1203 > 0f)));
let _e1209 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
let _e1212 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
let _e1216 = select(_e1212, _e1209, (_e1209 > _e1212));
let _e1219 = (select(_e1212, _e1209, (_e1209 < _e1212)) / select(1.1754944e-38f, _e1216, (_e1216 > 1.1754944e-38f)));
let _e1220 = (_e1219 > 0.41421357f);
let _e1224 = select(_e1219, ((_e1219 - 1f) / (_e1219 + 1f)), _e1220);
let _e1225 = (_e1224 * _e1224);
let _e1240 = (select(0f, 0.7853982f, _e1220) + (_e1224 + ((_e1224 * _e1225) * (-0.33333334f + (_e1225 * (0.2f + (_e1225 * (-0.14285713f + (_e1225 * (0.11111111f + (_e1225 * (-0.09090909f + (_e1225 * 0.0585f)))))))))))));
let _e1243 = select(_e1240, (1.5707964f - _e1240), (_e1212 > _e1209));
let _e1246 = select(_e1243, (3.1415927f - _e1243), (_e1206 < 0f));
let _e1251 = ((select(_e1246, -(_e1246), (_e1200 < 0f)) / _e1104) * 0.5f);
let _e1253 = select(-8e6f, _e1251, (_e1251 > -8e6f));
let _e1255 = select(8e6f, _e1253, (_e1253 < 8e6f));
let _e1262 = select(0i, select(select(i32(_e1255), i32(-2147483648), (_e1255 < -2147483600f)), 2147483647i, (_e1255 > 2147483500f)), (_e1255 == _e1255));
let _e1269 = ((_e1251 - f32((_e1262 - select(0i, 1i, (_e1255 < f32(_e1262)))))) * 2f);
let _e1277 = ((select(select((_e1269 - 2f), (1f - _e1269), (_e1269 < 1.5f)), _e1269, (_e1269 < 0.5f)) * 2f) / _e1107);
let _e1279 = select(-1f, _e1277, (_e1277 > -1f));
let _e1282 = (2f - _e1107);
let _e1284 = select(0f, _e1282, (_e1282 > 0f));
let _e1290 = (0.5f + ((0.5f * (select(1f, _e1188, (_e1188 < 1f)) * select(1f, _e1193, (_e1193 < 1f)))) * (select(1f, _e1279, (_e1279 < 1f)) * select(1f, _e1284, (_e1284 < 1f)))));
phi_3206_ = vec3<f32>((_e1052.member + ((_e1060.member - _e1052.member) * _e1290)), (_e1052.member_1 + ((_e1060.member_1 - _e1052.member_1) * _e1290)), (_e1052.member_2 + ((_e1060.member_2 - _e1052.member_2) * _e1290)));
} else {
let _e1304 = global_1.member.member_21.member_1;
let _e1305 = bitcast<i32>(_e1304);
let _e1310 = global_1.member.member_21.member_3;
let _e1312 = f32(bitcast<i32>(_e1310));
let _e1314 = (2f * 3.1415927f);
let _e1315 = ((_e1044 * f32(_e1305)) / _e1314);
let _e1317 = select(1e-6f, _e1315, (_e1315 > 1e-6f));
let _e1320 = bitcast<u32>(select(1.1754944e-38f, _e1317, (_e1317 > 1.1754944e-38f)));
let _e1321 = (_e1320 & 8388607u);
let _e1323 = select(0u, 1u, (_e1321 > 3474675u));
let _e1334 = bitcast<f32>((_e1321 | ((127u - _e1323) << bitcast<u32>(23i))));
let _e1337 = ((_e1334 - 1f) / (_e1334 + 1f));
let _e1338 = (_e1337 * _e1337);
let _e1353 = (f32(((bitcast<i32>((_e1320 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1323))) + (((2f * _e1337) + ((_e1337 * _e1338) * (0.6666667f + (_e1338 * (0.4f + (_e1338 * (0.2857143f + (_e1338 * (0.22222222f + (_e1338 * 0.18181819f)))))))))) * 1.442695f));
let _e1354 = (_e1312 - 1f);
let _e1356 = select(0f, _e1353, (_e1353 > 0f));
let _e1358 = select(_e1354, _e1356, (_e1356 < _e1354));
let _e1359 = (_e1312 - 2f);
let _e1361 = select(0f, _e1359, (_e1359 > 0f));
let _e1363 = select(0f, _e1358, (_e1358 > 0f));
let _e1365 = select(_e1361, _e1363, (_e1363 < _e1361));
let _e1372 = select(0i, select(select(i32(_e1365), i32(-2147483648), (_e1365 < -2147483600f)), 2147483647i, (_e1365 > 2147483500f)), (_e1365 == _e1365));
let _e1376 = (_e1372 - select(0i, 1i, (_e1365 < f32(_e1372))));
let _e1379 = bitcast<f32>((bitcast<u32>(_e616) & 2147483647u));
let _e1382 = bitcast<f32>((bitcast<u32>(_e604) & 2147483647u));
let _e1386 = select(_e1382, _e1379, (_e1379 > _e1382));
let _e1389 = (select(_e1382, _e1379, (_e1379 < _e1382)) / select(1.1754944e-38f, _e1386, (_e1386 > 1.1754944e-38f)));
let _e1390 = (_e1389 > 0.41421357f);
let _e1394 = select(_e1389, ((_e1389 - 1f) / (_e1389 + 1f)), _e1390);
let _e1395 = (_e1394 * _e1394);
let _e1410 = (select(0f, 0.7853982f, _e1390) + (_e1394 + ((_e1394 * _e1395) * (-0.33333334f + (_e1395 * (0.2f + (_e1395 * (-0.14285713f + (_e1395 * (0.11111111f + (_e1395 * (-0.09090909f + (_e1395 * 0.0585f)))))))))))));
let _e1413 = select(_e1410, (1.5707964f - _e1410), (_e1382 > _e1379));
let _e1416 = select(_e1413, (3.1415927f - _e1413), (_e616 < 0f));
let _e1421 = (0.5f - (select(_e1416, -(_e1416), (_e604 < 0f)) / _e1314));
let _e1423 = select(-1f, _e628, (_e628 > -1f));
let _e1425 = select(1f, _e1423, (_e1423 < 1f));
let _e1428 = ((1f - _e1425) * (1f + _e1425));
let _e1431 = sqrt(select(0f, _e1428, (_e1428 > 0f)));
let _e1434 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
let _e1437 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
let _e1441 = select(_e1437, _e1434, (_e1434 > _e1437));
let _e1444 = (select(_e1437, _e1434, (_e1434 < _e1437)) / select(1.1754944e-38f, _e1441, (_e1441 > 1.1754944e-38f)));
let _e1445 = (_e1444 > 0.41421357f);
let _e1449 = select(_e1444, ((_e1444 - 1f) / (_e1444 + 1f)), _e1445);
let _e1450 = (_e1449 * _e1449);
let _e1465 = (select(0f, 0.7853982f, _e1445) + (_e1449 + ((_e1449 * _e1450) * (-0.33333334f + (_e1450 * (0.2f + (_e1450 * (-0.14285713f + (_e1450 * (0.11111111f + (_e1450 * (-0.09090909f + (_e1450 * 0.0585f)))))))))))));
let _e1468 = select(_e1465, (1.5707964f - _e1465), (_e1437 > _e1434));
let _e1471 = select(_e1468, (3.1415927f - _e1468), (_e1431 < 0f));
let _e1476 = (0.5f - (select(_e1471, -(_e1471), (_e1425 < 0f)) / 3.1415927f));
let _e1480 = global_1.member.member_21.member_2;
let _e1481 = bitcast<i32>(_e1480);
phi_2425_ = 0i;
phi_2428_ = 0i;
phi_2430_ = _e1481;
phi_2432_ = _e1305;
loop {
let _e1483 = phi_2425_;
let _e1485 = phi_2428_;
let _e1487 = phi_2430_;
let _e1489 = phi_2432_;
local_12 = _e1489;
local_13 = _e1487;
local_14 = _e1489;
local_15 = _e1489;
local_16 = _e1489;
local_17 = _e1489;
local_18 = _e1489;
local_19 = _e1489;
local_20 = _e1487;
local_21 = _e1487;
local_22 = _e1487;
local_23 = _e1487;
local_24 = _e1489;
local_25 = _e1485;
local_26 = _e1489;
local_27 = _e1485;
let _e1490 = (_e1483 < _e1376);
if _e1490 {
if (_e1489 > 1i) {
phi_2447_ = (_e1489 >> bitcast<u32>(1i));
} else {
phi_2447_ = 1i;
}
let _e1497 = phi_2447_;
if (_e1487 > 1i) {
phi_2453_ = (_e1487 >> bitcast<u32>(1i));
} else {
phi_2453_ = 1i;
}
let _e1502 = phi_2453_;
phi_2426_ = (_e1483 + 1i);
phi_2429_ = (_e1485 + (_e1489 * _e1487));
phi_2431_ = _e1502;
phi_2433_ = _e1497;
} else {
phi_2426_ = i32();
phi_2429_ = i32();
phi_2431_ = i32();
phi_2433_ = i32();
}
let _e1505 = phi_2426_;
let _e1507 = phi_2429_;
let _e1509 = phi_2431_;
let _e1511 = phi_2433_;
continue;
continuing {
phi_2425_ = _e1505;
phi_2428_ = _e1507;
phi_2430_ = _e1509;
phi_2432_ = _e1511;
break if !(_e1490);
}
}
let _e1514 = local_12;
let _e1515 = f32(_e1514);
let _e1517 = ((_e1421 * _e1515) - 0.5f);
let _e1519 = local_13;
let _e1520 = f32(_e1519);
let _e1522 = ((_e1476 * _e1520) - 0.5f);
let _e1524 = select(-1f, _e1517, (_e1517 > -1f));
let _e1526 = select(_e1515, _e1524, (_e1524 < _e1515));
let _e1533 = select(0i, select(select(i32(_e1526), i32(-2147483648), (_e1526 < -2147483600f)), 2147483647i, (_e1526 > 2147483500f)), (_e1526 == _e1526));
let _e1537 = (_e1533 - select(0i, 1i, (_e1526 < f32(_e1533))));
let _e1539 = select(-1f, _e1522, (_e1522 > -1f));
let _e1541 = select(_e1520, _e1539, (_e1539 < _e1520));
let _e1548 = select(0i, select(select(i32(_e1541), i32(-2147483648), (_e1541 < -2147483600f)), 2147483647i, (_e1541 > 2147483500f)), (_e1541 == _e1541));
let _e1552 = (_e1548 - select(0i, 1i, (_e1541 < f32(_e1548))));
let _e1554 = (_e1517 - f32(_e1537));
let _e1556 = (_e1522 - f32(_e1552));
let _e1558 = select(0f, _e1556, (_e1556 > 0f));
let _e1560 = select(1f, _e1558, (_e1558 < 1f));
if (_e1537 < 0i) {
let _e1563 = local_14;
phi_2528_ = (_e1537 + _e1563);
} else {
phi_2528_ = _e1537;
}
let _e1566 = phi_2528_;
let _e1568 = local_15;
if (_e1566 >= _e1568) {
let _e1571 = local_16;
phi_2534_ = (_e1566 - _e1571);
} else {
phi_2534_ = _e1566;
}
let _e1574 = phi_2534_;
let _e1575 = (_e1537 + 1i);
if (_e1575 < 0i) {
let _e1578 = local_17;
phi_2541_ = (_e1575 + _e1578);
} else {
phi_2541_ = _e1575;
}
let _e1581 = phi_2541_;
let _e1583 = local_18;
if (_e1581 >= _e1583) {
let _e1586 = local_19;
phi_2547_ = (_e1581 - _e1586);
} else {
phi_2547_ = _e1581;
}
let _e1589 = phi_2547_;
let _e1591 = select(_e1552, 0i, (_e1552 < 0i));
let _e1593 = local_20;
if (_e1591 >= _e1593) {
let _e1596 = local_21;
phi_2558_ = (_e1596 - 1i);
} else {
phi_2558_ = _e1591;
}
let _e1599 = phi_2558_;
let _e1600 = (_e1552 + 1i);
let _e1602 = select(_e1600, 0i, (_e1600 < 0i));
let _e1604 = local_22;
if (_e1602 >= _e1604) {
let _e1607 = local_23;
phi_2570_ = (_e1607 - 1i);
} else {
phi_2570_ = _e1602;
}
let _e1610 = phi_2570_;
let _e1612 = local_24;
let _e1615 = local_25;
let _e1616 = (_e1615 + (_e1599 * _e1612));
let _e1618 = local_26;
let _e1621 = local_27;
let _e1622 = (_e1621 + (_e1610 * _e1618));
let _e1624 = (3i * (_e1616 + _e1574));
let _e1626 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1628 = select(_e1626, _e1624, (_e1624 < _e1626));
let _e1634 = global_3.member[bitcast<u32>(select(0i, _e1628, (_e1628 > 0i)))];
let _e1635 = (_e1624 + 1i);
let _e1637 = select(_e1626, _e1635, (_e1635 < _e1626));
let _e1643 = global_3.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1644 = (_e1624 + 2i);
let _e1646 = select(_e1626, _e1644, (_e1644 < _e1626));
let _e1652 = global_3.member[bitcast<u32>(select(0i, _e1646, (_e1646 > 0i)))];
let _e1654 = (3i * (_e1616 + _e1589));
let _e1656 = select(_e1626, _e1654, (_e1654 < _e1626));
let _e1662 = global_3.member[bitcast<u32>(select(0i, _e1656, (_e1656 > 0i)))];
let _e1663 = (_e1654 + 1i);
let _e1665 = select(_e1626, _e1663, (_e1663 < _e1626));
let _e1671 = global_3.member[bitcast<u32>(select(0i, _e1665, (_e1665 > 0i)))];
let _e1672 = (_e1654 + 2i);
let _e1674 = select(_e1626, _e1672, (_e1672 < _e1626));
let _e1680 = global_3.member[bitcast<u32>(select(0i, _e1674, (_e1674 > 0i)))];
let _e1682 = (3i * (_e1622 + _e1574));
let _e1684 = select(_e1626, _e1682, (_e1682 < _e1626));
let _e1690 = global_3.member[bitcast<u32>(select(0i, _e1684, (_e1684 > 0i)))];
let _e1691 = (_e1682 + 1i);
let _e1693 = select(_e1626, _e1691, (_e1691 < _e1626));
let _e1699 = global_3.member[bitcast<u32>(select(0i, _e1693, (_e1693 > 0i)))];
let _e1700 = (_e1682 + 2i);
let _e1702 = select(_e1626, _e1700, (_e1700 < _e1626));
let _e1708 = global_3.member[bitcast<u32>(select(0i, _e1702, (_e1702 > 0i)))];
let _e1710 = (3i * (_e1622 + _e1589));
let _e1712 = select(_e1626, _e1710, (_e1710 < _e1626));
let _e1718 = global_3.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1719 = (_e1710 + 1i);
let _e1721 = select(_e1626, _e1719, (_e1719 < _e1626));
let _e1727 = global_3.member[bitcast<u32>(select(0i, _e1721, (_e1721 > 0i)))];
let _e1728 = (_e1710 + 2i);
let _e1730 = select(_e1626, _e1728, (_e1728 < _e1626));
let _e1736 = global_3.member[bitcast<u32>(select(0i, _e1730, (_e1730 > 0i)))];
let _e1743 = (_e1634 + ((_e1662 - _e1634) * _e1554));
let _e1744 = (_e1643 + ((_e1671 - _e1643) * _e1554));
let _e1745 = (_e1652 + ((_e1680 - _e1652) * _e1554));
let _e1761 = (_e1743 + (((_e1690 + ((_e1718 - _e1690) * _e1554)) - _e1743) * _e1560));
let _e1762 = (_e1744 + (((_e1699 + ((_e1727 - _e1699) * _e1554)) - _e1744) * _e1560));
let _e1763 = (_e1745 + (((_e1708 + ((_e1736 - _e1708) * _e1554)) - _e1745) * _e1560));
phi_2806_ = 0i;
phi_2809_ = 0i;
phi_2811_ = _e1481;
phi_2813_ = _e1305;
loop {
let _e1766 = phi_2806_;
let _e1768 = phi_2809_;
let _e1770 = phi_2811_;
let _e1772 = phi_2813_;
local_28 = _e1772;
local_29 = _e1770;
local_30 = _e1772;
local_31 = _e1772;
local_32 = _e1772;
local_33 = _e1772;
local_34 = _e1772;
local_35 = _e1772;
local_36 = _e1770;
local_37 = _e1770;
local_38 = _e1770;
local_39 = _e1770;
local_40 = _e1772;
local_41 = _e1768;
local_42 = _e1772;
local_43 = _e1768;
let _e1773 = (_e1766 < (_e1376 + 1i));
if _e1773 {
if (_e1772 > 1i) {
phi_2828_ = (_e1772 >> bitcast<u32>(1i));
} else {
phi_2828_ = 1i;
}
let _e1780 = phi_2828_;
if (_e1770 > 1i) {
phi_2834_ = (_e1770 >> bitcast<u32>(1i));
} else {
phi_2834_ = 1i;
}
let _e1785 = phi_2834_;
phi_2807_ = (_e1766 + 1i);
phi_2810_ = (_e1768 + (_e1772 * _e1770));
phi_2812_ = _e1785;
phi_2814_ = _e1780;
} else {
phi_2807_ = i32();
phi_2810_ = i32();
phi_2812_ = i32();
phi_2814_ = i32();
}
let _e1788 = phi_2807_;
let _e1790 = phi_2810_;
let _e1792 = phi_2812_;
let _e1794 = phi_2814_;
continue;
continuing {
phi_2806_ = _e1788;
phi_2809_ = _e1790;
phi_2811_ = _e1792;
phi_2813_ = _e1794;
break if !(_e1773);
}
}
let _e1797 = local_28;
let _e1798 = f32(_e1797);
let _e1800 = ((_e1421 * _e1798) - 0.5f);
let _e1802 = local_29;
let _e1803 = f32(_e1802);
let _e1805 = ((_e1476 * _e1803) - 0.5f);
let _e1807 = select(-1f, _e1800, (_e1800 > -1f));
let _e1809 = select(_e1798, _e1807, (_e1807 < _e1798));
let _e1816 = select(0i, select(select(i32(_e1809), i32(-2147483648), (_e1809 < -2147483600f)), 2147483647i, (_e1809 > 2147483500f)), (_e1809 == _e1809));
let _e1820 = (_e1816 - select(0i, 1i, (_e1809 < f32(_e1816))));
let _e1822 = select(-1f, _e1805, (_e1805 > -1f));
let _e1824 = select(_e1803, _e1822, (_e1822 < _e1803));
let _e1831 = select(0i, select(select(i32(_e1824), i32(-2147483648), (_e1824 < -2147483600f)), 2147483647i, (_e1824 > 2147483500f)), (_e1824 == _e1824));
let _e1835 = (_e1831 - select(0i, 1i, (_e1824 < f32(_e1831))));
let _e1837 = (_e1800 - f32(_e1820));
let _e1839 = (_e1805 - f32(_e1835));
let _e1841 = select(0f, _e1839, (_e1839 > 0f));
let _e1843 = select(1f, _e1841, (_e1841 < 1f));
if (_e1820 < 0i) {
let _e1846 = local_30;
phi_2909_ = (_e1820 + _e1846);
} else {
phi_2909_ = _e1820;
}
let _e1849 = phi_2909_;
let _e1851 = local_31;
if (_e1849 >= _e1851) {
let _e1854 = local_32;
phi_2915_ = (_e1849 - _e1854);
} else {
phi_2915_ = _e1849;
}
let _e1857 = phi_2915_;
let _e1858 = (_e1820 + 1i);
if (_e1858 < 0i) {
let _e1861 = local_33;
phi_2922_ = (_e1858 + _e1861);
} else {
phi_2922_ = _e1858;
}
let _e1864 = phi_2922_;
let _e1866 = local_34;
if (_e1864 >= _e1866) {
let _e1869 = local_35;
phi_2928_ = (_e1864 - _e1869);
} else {
phi_2928_ = _e1864;
}
let _e1872 = phi_2928_;
let _e1874 = select(_e1835, 0i, (_e1835 < 0i));
let _e1876 = local_36;
if (_e1874 >= _e1876) {
let _e1879 = local_37;
phi_2939_ = (_e1879 - 1i);
} else {
phi_2939_ = _e1874;
}
let _e1882 = phi_2939_;
let _e1883 = (_e1835 + 1i);
let _e1885 = select(_e1883, 0i, (_e1883 < 0i));
let _e1887 = local_38;
if (_e1885 >= _e1887) {
let _e1890 = local_39;
phi_2951_ = (_e1890 - 1i);
} else {
phi_2951_ = _e1885;
}
let _e1893 = phi_2951_;
let _e1895 = local_40;
let _e1898 = local_41;
let _e1899 = (_e1898 + (_e1882 * _e1895));
let _e1901 = local_42;
let _e1904 = local_43;
let _e1905 = (_e1904 + (_e1893 * _e1901));
let _e1907 = (3i * (_e1899 + _e1857));
let _e1909 = select(_e1626, _e1907, (_e1907 < _e1626));
let _e1915 = global_3.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1916 = (_e1907 + 1i);
let _e1918 = select(_e1626, _e1916, (_e1916 < _e1626));
let _e1924 = global_3.member[bitcast<u32>(select(0i, _e1918, (_e1918 > 0i)))];
let _e1925 = (_e1907 + 2i);
let _e1927 = select(_e1626, _e1925, (_e1925 < _e1626));
let _e1933 = global_3.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1935 = (3i * (_e1899 + _e1872));
let _e1937 = select(_e1626, _e1935, (_e1935 < _e1626));
let _e1943 = global_3.member[bitcast<u32>(select(0i, _e1937, (_e1937 > 0i)))];
let _e1944 = (_e1935 + 1i);
let _e1946 = select(_e1626, _e1944, (_e1944 < _e1626));
let _e1952 = global_3.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1953 = (_e1935 + 2i);
let _e1955 = select(_e1626, _e1953, (_e1953 < _e1626));
let _e1961 = global_3.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1963 = (3i * (_e1905 + _e1857));
let _e1965 = select(_e1626, _e1963, (_e1963 < _e1626));
let _e1971 = global_3.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1972 = (_e1963 + 1i);
let _e1974 = select(_e1626, _e1972, (_e1972 < _e1626));
let _e1980 = global_3.member[bitcast<u32>(select(0i, _e1974, (_e1974 > 0i)))];
let _e1981 = (_e1963 + 2i);
let _e1983 = select(_e1626, _e1981, (_e1981 < _e1626));
let _e1989 = global_3.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e1991 = (3i * (_e1905 + _e1872));
let _e1993 = select(_e1626, _e1991, (_e1991 < _e1626));
let _e1999 = global_3.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e2000 = (_e1991 + 1i);
let _e2002 = select(_e1626, _e2000, (_e2000 < _e1626));
let _e2008 = global_3.member[bitcast<u32>(select(0i, _e2002, (_e2002 > 0i)))];
let _e2009 = (_e1991 + 2i);
let _e2011 = select(_e1626, _e2009, (_e2009 < _e1626));
let _e2017 = global_3.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2024 = (_e1915 + ((_e1943 - _e1915) * _e1837));
let _e2025 = (_e1924 + ((_e1952 - _e1924) * _e1837));
let _e2026 = (_e1933 + ((_e1961 - _e1933) * _e1837));
let _e2049 = (_e1358 - f32(_e1376));
let _e2051 = select(0f, _e2049, (_e2049 > 0f));
let _e2053 = select(1f, _e2051, (_e2051 < 1f));
let _e2063 = global_1.member.member_21.member_11;
phi_3206_ = vec3<f32>(((_e1761 + (((_e2024 + (((_e1971 + ((_e1999 - _e1971) * _e1837)) - _e2024) * _e1843)) - _e1761) * _e2053)) * _e2063), ((_e1762 + (((_e2025 + (((_e1980 + ((_e2008 - _e1980) * _e1837)) - _e2025) * _e1843)) - _e1762) * _e2053)) * _e2063), ((_e1763 + (((_e2026 + (((_e1989 + ((_e2017 - _e1989) * _e1837)) - _e2026) * _e1843)) - _e1763) * _e2053)) * _e2063));
}
let _e2069 = phi_3206_;
phi_3207_ = _e2069;
}
let _e2071 = phi_3207_;
phi_3208_ = _e2071;
}
let _e2073 = phi_3208_;
let _e2077 = global_1.member.member_21.member_12;
let _e2084 = (_e544 * _e2077);
let _e2096 = (1f - ((_e544 * ((_e237 + _e248) + _e259)) * (1f / 3f)));
global_4.member[_e124] = ((_e182 + ((_e237 * (select(_e441.member, _e430.member, _e419) * (((_e463.member * _e491) * _e514) + _e497.member))) * _e529)) + ((_e237 * _e2073.x) * _e2084));
global_4.member[(_e122 + _e124)] = ((_e193 + ((_e248 * (select(_e441.member_1, _e430.member_1, _e419) * (((_e463.member_1 * _e491) * _e514) + _e497.member_1))) * _e529)) + ((_e248 * _e2073.y) * _e2084));
global_4.member[((2u * _e122) + _e124)] = ((_e204 + ((_e259 * (select(_e441.member_2, _e430.member_2, _e419) * (((_e463.member_2 * _e491) * _e514) + _e497.member_2))) * _e529)) + ((_e259 * _e2073.z) * _e2084));
global_4.member[((3u * _e122) + _e124)] = (_e2096 + ((1f - _e2096) * _e2077));
global_4.member[((4u * _e122) + _e124)] = _e539;
global_4.member[((5u * _e122) + _e124)] = _e237;
global_4.member[((6u * _e122) + _e124)] = _e248;
global_4.member[((7u * _e122) + _e124)] = _e259;
global_4.member[((8u * _e122) + _e124)] = ((_e226 + (_e529 * (_e349 + (_e306 * select(_e380, _e411, _e415))))) / select(1e-12f, _e539, (_e539 > 1e-12f)));
global_4.member[((9u * _e122) + _e124)] = _e304;
global_4.member[((10u * _e122) + _e124)] = _e305;
global_4.member[((11u * _e122) + _e124)] = -(_e306);
global_4.member[((12u * _e122) + _e124)] = _e347;
global_4.member[((13u * _e122) + _e124)] = _e348;
global_4.member[((14u * _e122) + _e124)] = -(_e349);
global_4.member[((15u * _e122) + _e124)] = select(_e171, 2f, (_e171 == 4f));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
