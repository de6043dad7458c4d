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
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_24 {
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
member_17: type_14,
member_18: type_22,
member_19: type_5,
member_20: type_23,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
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
member_10: type_24,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_25,
member_15: type_25,
member_16: type_25,
member_17: type_25,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_27;
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
var phi_247_: u32;
var phi_1177_: u32;
var phi_1514_: f32;
var phi_1570_: f32;
var phi_1575_: vec3<f32>;
var phi_1678_: f32;
var phi_1762_: f32;
var phi_1834_: type_28;
var phi_1835_: type_28;
var phi_2116_: i32;
var phi_2124_: i32;
var phi_2130_: i32;
var phi_2138_: i32;
var phi_2179_: u32;
var phi_2349_: u32;
var phi_2533_: u32;
var phi_2703_: u32;
var phi_2912_: vec3<f32>;
var phi_3514_: i32;
var phi_3517_: i32;
var phi_3519_: i32;
var phi_3521_: i32;
var phi_3536_: i32;
var phi_3542_: i32;
var phi_3515_: i32;
var phi_3518_: i32;
var phi_3520_: i32;
var phi_3522_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_3617_: i32;
var local_15: i32;
var local_16: i32;
var phi_3623_: i32;
var local_17: i32;
var phi_3630_: i32;
var local_18: i32;
var local_19: i32;
var phi_3636_: i32;
var local_20: i32;
var local_21: i32;
var phi_3647_: i32;
var local_22: i32;
var local_23: i32;
var phi_3659_: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var phi_3895_: i32;
var phi_3898_: i32;
var phi_3900_: i32;
var phi_3902_: i32;
var phi_3917_: i32;
var phi_3923_: i32;
var phi_3896_: i32;
var phi_3899_: i32;
var phi_3901_: i32;
var phi_3903_: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var phi_3998_: i32;
var local_31: i32;
var local_32: i32;
var phi_4004_: i32;
var local_33: i32;
var phi_4011_: i32;
var local_34: i32;
var local_35: i32;
var phi_4017_: i32;
var local_36: i32;
var local_37: i32;
var phi_4028_: i32;
var local_38: i32;
var local_39: i32;
var phi_4040_: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var phi_4295_: vec3<f32>;
var phi_4296_: vec3<f32>;
var phi_4297_: vec3<f32>;
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
phi_247_ = ((((_e123 - _e138) + (_e137 / 4u)) * _e132) + (((_e121 - _e137) + (_e138 * 4u)) + (_e137 % 4u)));
} else {
phi_247_ = ((_e123 * _e132) + _e121);
}
let _e159 = phi_247_;
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
let _e525 = global_2.member.member_10.member_19;
let _e529 = (_e486 - _e525.member);
let _e530 = (_e501 - _e525.member_1);
let _e531 = (_e516 - _e525.member_2);
let _e536 = (((_e529 * _e529) + (_e530 * _e530)) + (_e531 * _e531));
let _e539 = sqrt(select(0f, _e536, (_e536 > 0f)));
let _e542 = (1f / select(1e-20f, _e539, (_e539 > 1e-20f)));
let _e546 = select(0f, (_e529 * _e542), _e521);
let _e547 = select(0f, (_e530 * _e542), _e521);
let _e548 = select(1f, (_e531 * _e542), _e521);
let _e553 = global_2.member.member_10.member.member;
let _e564 = global_2.member.member_10.member_1.member;
let _e578 = global_2.member.member_10.member_2.member;
let _e587 = (vec3<f32>(((_e553.member * _e546) + (_e564.member * _e547)), ((_e553.member_1 * _e546) + (_e564.member_1 * _e547)), ((_e553.member_2 * _e546) + (_e564.member_2 * _e547))) + vec3<f32>((_e578.member * _e548), (_e578.member_1 * _e548), (_e578.member_2 * _e548)));
let _e590 = global_2.member.member_1;
if ((_e590 & 256u) != 0u) {
let _e598 = global_2.member.member_10.member_18.member.member;
let _e599 = bitcast<i32>(_e598);
let _e605 = global_2.member.member_10.member_18.member.member_1;
let _e606 = bitcast<i32>(_e605);
let _e611 = global_2.member.member_10.member_19.member_2;
let _e613 = select(1f, (_e516 - _e611), _e521);
let _e616 = (1f / select(1e-12f, _e613, (_e613 > 1e-12f)));
let _e621 = global_2.member.member_10.member_5;
let _e626 = global_2.member.member_10.member_8;
let _e627 = (((_e486 * _e616) - _e621) * _e626);
let _e632 = global_2.member.member_10.member_6;
let _e634 = (((_e501 * _e616) - _e632) * _e626);
let _e639 = global_2.member.member_10.member_4.member;
let _e641 = f32(bitcast<i32>(_e639));
let _e643 = select(0f, _e627, (_e627 > 0f));
let _e650 = global_2.member.member_10.member_18.member_1;
let _e653 = ((_e627 - _e641) * _e650);
let _e658 = global_2.member.member_10.member_18.member_2;
let _e660 = select(0f, _e653, (_e653 > 0f));
let _e662 = (_e658 + _e660);
let _e667 = (-(_e627) * _e650);
let _e669 = select(0f, _e667, (_e667 > 0f));
let _e671 = (_e658 + _e669);
let _e678 = (((_e658 + (select(_e641, _e643, (_e643 < _e641)) * _e650)) + (((_e660 * _e658) / select(1e-12f, _e662, (_e662 > 1e-12f))) - ((_e669 * _e658) / select(1e-12f, _e671, (_e671 > 1e-12f))))) - 0.5f);
let _e683 = global_2.member.member_10.member_4.member_1;
let _e685 = f32(bitcast<i32>(_e683));
let _e687 = select(0f, _e634, (_e634 > 0f));
let _e692 = ((_e634 - _e685) * _e650);
let _e694 = select(0f, _e692, (_e692 > 0f));
let _e696 = (_e658 + _e694);
let _e701 = (-(_e634) * _e650);
let _e703 = select(0f, _e701, (_e701 > 0f));
let _e705 = (_e658 + _e703);
let _e712 = (((_e658 + (select(_e685, _e687, (_e687 < _e685)) * _e650)) + (((_e694 * _e658) / select(1e-12f, _e696, (_e696 > 1e-12f))) - ((_e703 * _e658) / select(1e-12f, _e705, (_e705 > 1e-12f))))) - 0.5f);
let _e714 = f32((_e599 - 2i));
let _e716 = select(0f, _e678, (_e678 > 0f));
let _e718 = select(_e714, _e716, (_e716 < _e714));
let _e725 = select(0i, select(select(i32(_e718), i32(-2147483648), (_e718 < -2147483600f)), 2147483647i, (_e718 > 2147483500f)), (_e718 == _e718));
let _e729 = (_e725 - select(0i, 1i, (_e718 < f32(_e725))));
let _e731 = f32((_e606 - 2i));
let _e733 = select(0f, _e712, (_e712 > 0f));
let _e735 = select(_e731, _e733, (_e733 < _e731));
let _e742 = select(0i, select(select(i32(_e735), i32(-2147483648), (_e735 < -2147483600f)), 2147483647i, (_e735 > 2147483500f)), (_e735 == _e735));
let _e746 = (_e742 - select(0i, 1i, (_e735 < f32(_e742))));
let _e748 = (_e678 - f32(_e729));
let _e750 = select(0f, _e748, (_e748 > 0f));
let _e752 = select(1f, _e750, (_e750 < 1f));
let _e754 = (_e712 - f32(_e746));
let _e756 = select(0f, _e754, (_e754 > 0f));
let _e758 = select(1f, _e756, (_e756 < 1f));
if _e423 {
let _e763 = global_2.member.member_10.member_18.member_4;
phi_1177_ = _e763;
} else {
let _e768 = global_2.member.member_10.member_18.member_3;
phi_1177_ = _e768;
}
let _e770 = phi_1177_;
let _e774 = ((bitcast<i32>(_e770) + (_e746 * _e599)) + _e729);
let _e775 = (_e599 * _e606);
let _e777 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e779 = select(_e777, _e774, (_e774 < _e777));
let _e785 = global_5.member[bitcast<u32>(select(0i, _e779, (_e779 > 0i)))];
let _e786 = bitcast<f32>(_e785);
let _e787 = (_e774 + 1i);
let _e789 = select(_e777, _e787, (_e787 < _e777));
let _e795 = global_5.member[bitcast<u32>(select(0i, _e789, (_e789 > 0i)))];
let _e799 = (_e786 + ((bitcast<f32>(_e795) - _e786) * _e752));
let _e800 = (_e774 + _e599);
let _e802 = select(_e777, _e800, (_e800 < _e777));
let _e808 = global_5.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e809 = bitcast<f32>(_e808);
let _e810 = (_e800 + 1i);
let _e812 = select(_e777, _e810, (_e810 < _e777));
let _e818 = global_5.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
let _e825 = (_e799 + (((_e809 + ((bitcast<f32>(_e818) - _e809) * _e752)) - _e799) * _e758));
let _e826 = (_e774 + _e775);
let _e828 = select(_e777, _e826, (_e826 < _e777));
let _e834 = global_5.member[bitcast<u32>(select(0i, _e828, (_e828 > 0i)))];
let _e835 = bitcast<f32>(_e834);
let _e836 = (_e826 + 1i);
let _e838 = select(_e777, _e836, (_e836 < _e777));
let _e844 = global_5.member[bitcast<u32>(select(0i, _e838, (_e838 > 0i)))];
let _e848 = (_e835 + ((bitcast<f32>(_e844) - _e835) * _e752));
let _e849 = (_e826 + _e599);
let _e851 = select(_e777, _e849, (_e849 < _e777));
let _e857 = global_5.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = bitcast<f32>(_e857);
let _e859 = (_e849 + 1i);
let _e861 = select(_e777, _e859, (_e859 < _e777));
let _e867 = global_5.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
let _e874 = (_e848 + (((_e858 + ((bitcast<f32>(_e867) - _e858) * _e752)) - _e848) * _e758));
let _e876 = (_e774 + (2i * _e775));
let _e878 = select(_e777, _e876, (_e876 < _e777));
let _e884 = global_5.member[bitcast<u32>(select(0i, _e878, (_e878 > 0i)))];
let _e885 = bitcast<f32>(_e884);
let _e886 = (_e876 + 1i);
let _e888 = select(_e777, _e886, (_e886 < _e777));
let _e894 = global_5.member[bitcast<u32>(select(0i, _e888, (_e888 > 0i)))];
let _e898 = (_e885 + ((bitcast<f32>(_e894) - _e885) * _e752));
let _e899 = (_e876 + _e599);
let _e901 = select(_e777, _e899, (_e899 < _e777));
let _e907 = global_5.member[bitcast<u32>(select(0i, _e901, (_e901 > 0i)))];
let _e908 = bitcast<f32>(_e907);
let _e909 = (_e899 + 1i);
let _e911 = select(_e777, _e909, (_e909 < _e777));
let _e917 = global_5.member[bitcast<u32>(select(0i, _e911, (_e911 > 0i)))];
let _e924 = (_e898 + (((_e908 + ((bitcast<f32>(_e917) - _e908) * _e752)) - _e898) * _e758));
let _e926 = (_e520 == 0u);
if _e926 {
phi_1575_ = vec3<f32>(_e825, _e874, _e924);
} else {
if _e926 {
phi_1514_ = 1f;
} else {
let _e931 = global_2.member.member_10.member_20.member;
let _e939 = (((_e931.member * _e529) + (_e931.member_1 * _e530)) + (_e931.member_2 * _e531));
let _e943 = (_e529 - (_e931.member * _e939));
let _e944 = (_e530 - (_e931.member_1 * _e939));
let _e945 = (_e531 - (_e931.member_2 * _e939));
let _e950 = (((_e943 * _e943) + (_e944 * _e944)) + (_e945 * _e945));
let _e961 = global_2.member.member_10.member_20.member_1;
let _e967 = global_2.member.member_10.member_20.member_2;
let _e968 = ((_e961 - (sqrt(select(0f, _e950, (_e950 > 0f))) / select(1e-20f, _e939, (_e939 > 1e-20f)))) * _e967);
let _e970 = select(0f, _e968, (_e968 > 0f));
let _e972 = select(1f, _e970, (_e970 < 1f));
phi_1514_ = select(1f, select(0f, ((_e972 * _e972) * (3f - (2f * _e972))), (_e939 > 0f)), (_e967 > 0f));
}
let _e982 = phi_1514_;
let _e984 = select(0f, 1f, (_e531 > 0f));
let _e988 = ((_e825 * _e984) + _e982);
let _e989 = ((_e874 * _e984) + _e982);
let _e990 = ((_e924 * _e984) + _e982);
if _e926 {
phi_1570_ = 1f;
} else {
phi_1570_ = (1f / select(1e-12f, _e536, (_e536 > 1e-12f)));
}
let _e1001 = phi_1570_;
phi_1575_ = vec3<f32>((select(0f, _e988, (_e988 > 0f)) * _e1001), (select(0f, _e989, (_e989 > 0f)) * _e1001), (select(0f, _e990, (_e990 > 0f)) * _e1001));
}
let _e1007 = phi_1575_;
let _e1011 = global_2.member.member_9.member_1;
phi_1835_ = type_28((vec3<f32>(_e1011.member, _e1011.member_1, _e1011.member_2) * _e1007), _e587);
} else {
let _e1018 = (_e520 == 0u);
if _e1018 {
let _e1022 = global_2.member.member_9.member_1;
let _e1030 = global_2.member.member_9.member;
phi_1834_ = type_28(vec3<f32>(_e1022.member, _e1022.member_1, _e1022.member_2), vec3<f32>(_e1030.member, _e1030.member_1, _e1030.member_2));
} else {
let _e1039 = global_2.member.member_9.member_1;
if _e1018 {
phi_1678_ = 1f;
} else {
phi_1678_ = (1f / select(1e-12f, _e536, (_e536 > 1e-12f)));
}
let _e1047 = phi_1678_;
if _e1018 {
phi_1762_ = 1f;
} else {
let _e1052 = global_2.member.member_10.member_20.member;
let _e1060 = (((_e1052.member * _e529) + (_e1052.member_1 * _e530)) + (_e1052.member_2 * _e531));
let _e1064 = (_e529 - (_e1052.member * _e1060));
let _e1065 = (_e530 - (_e1052.member_1 * _e1060));
let _e1066 = (_e531 - (_e1052.member_2 * _e1060));
let _e1071 = (((_e1064 * _e1064) + (_e1065 * _e1065)) + (_e1066 * _e1066));
let _e1082 = global_2.member.member_10.member_20.member_1;
let _e1088 = global_2.member.member_10.member_20.member_2;
let _e1089 = ((_e1082 - (sqrt(select(0f, _e1071, (_e1071 > 0f))) / select(1e-20f, _e1060, (_e1060 > 1e-20f)))) * _e1088);
let _e1091 = select(0f, _e1089, (_e1089 > 0f));
let _e1093 = select(1f, _e1091, (_e1091 < 1f));
phi_1762_ = select(1f, select(0f, ((_e1093 * _e1093) * (3f - (2f * _e1093))), (_e1060 > 0f)), (_e1088 > 0f));
}
let _e1103 = phi_1762_;
let _e1104 = (_e1047 * _e1103);
phi_1834_ = type_28(vec3<f32>((_e1039.member * _e1104), (_e1039.member_1 * _e1104), (_e1039.member_2 * _e1104)), _e587);
}
let _e1111 = phi_1834_;
phi_1835_ = _e1111;
}
let _e1113 = phi_1835_;
let _e1122 = (((_e1113.member_1.x * _e1113.member_1.x) + (_e1113.member_1.y * _e1113.member_1.y)) + (_e1113.member_1.z * _e1113.member_1.z));
let _e1125 = sqrt(select(0f, _e1122, (_e1122 > 0f)));
let _e1131 = (1e-6f * _e1125);
let _e1135 = select((_e1125 / select(_e1131, _e1113.member_1.z, (_e1113.member_1.z > _e1131))), 1f, ((_e590 & 8u) != 0u));
let _e1144 = global_2.member.member_18;
let _e1156 = (-((((select(_e440.member, _e429.member, _e423) * _e1113.member_1.x) + (select(_e440.member_1, _e429.member_1, _e423) * _e1113.member_1.y)) + (select(_e440.member_2, _e429.member_2, _e423) * _e1113.member_1.z))) / select(1e-20f, _e1125, (_e1125 > 1e-20f)));
let _e1161 = bitcast<f32>((bitcast<u32>(select(0f, _e1156, (_e1156 > 0f))) & 2147483647u));
let _e1174 = ((_e311 || (_e175 == 3f)) && (_e421 != -1i));
let _e1179 = select(0f, (1f - _e219), _e1174);
let _e1189 = (_e219 + _e1179);
let _e1194 = (1f - _e1189);
let _e1195 = local_10;
local_8 = _e1195;
local_9 = _e162;
let _e1196 = local_9;
let _e1198 = local_8;
let _e1199 = ((3i * _e1196) + _e1198);
let _e1201 = select(_e168, _e1199, (_e1199 < _e168));
let _e1206 = global_3.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1207 = local_9;
let _e1209 = local_8;
let _e1210 = ((4i * _e1207) + _e1209);
let _e1212 = select(_e168, _e1210, (_e1210 < _e168));
let _e1217 = global_3.member[bitcast<u32>(select(0i, _e1212, (_e1212 > 0i)))];
let _e1218 = local_9;
let _e1220 = local_8;
let _e1221 = ((5i * _e1218) + _e1220);
let _e1223 = select(_e168, _e1221, (_e1221 < _e168));
let _e1228 = global_3.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1233 = (((_e1206 * _e1206) + (_e1217 * _e1217)) + (_e1228 * _e1228));
let _e1236 = sqrt(select(0f, _e1233, (_e1233 > 0f)));
let _e1239 = (1f / select(1e-20f, _e1236, (_e1236 > 1e-20f)));
let _e1240 = (_e1206 * _e1239);
let _e1241 = (_e1217 * _e1239);
let _e1242 = (_e1228 * _e1239);
let _e1246 = global_2.member.member_21.member_4;
let _e1254 = (((_e1246.member * _e1240) + (_e1246.member_1 * _e1241)) + (_e1246.member_2 * _e1242));
let _e1258 = global_2.member.member_21.member_5;
let _e1266 = (((_e1258.member * _e1240) + (_e1258.member_1 * _e1241)) + (_e1258.member_2 * _e1242));
let _e1270 = global_2.member.member_21.member_6;
let _e1278 = (((_e1270.member * _e1240) + (_e1270.member_1 * _e1241)) + (_e1270.member_2 * _e1242));
let _e1279 = bitcast<i32>(_e121);
let _e1280 = bitcast<i32>(_e123);
if (_e1279 > 0i) {
phi_2116_ = (_e1279 - 1i);
} else {
phi_2116_ = 0i;
}
let _e1286 = phi_2116_;
let _e1287 = (bitcast<i32>(_e132) - 1i);
if (_e1279 < _e1287) {
phi_2124_ = (_e1279 + 1i);
} else {
phi_2124_ = _e1287;
}
let _e1291 = phi_2124_;
if (_e1280 > 0i) {
phi_2130_ = (_e1280 - 1i);
} else {
phi_2130_ = 0i;
}
let _e1295 = phi_2130_;
let _e1296 = (bitcast<i32>(_e136) - 1i);
if (_e1280 < _e1296) {
phi_2138_ = (_e1280 + 1i);
} else {
phi_2138_ = _e1296;
}
let _e1300 = phi_2138_;
let _e1303 = global_2.member.member_3.member;
let _e1306 = global_2.member.member_3.member_1;
let _e1307 = bitcast<u32>(_e1291);
let _e1308 = bitcast<u32>(_e1280);
let _e1309 = (_e1307 % 16u);
let _e1310 = (_e1308 % 4u);
let _e1312 = (_e1303 - (_e1303 % 16u));
let _e1315 = (_e1306 - (_e1306 % 4u));
let _e1316 = (_e1308 < _e1315);
if ((_e1307 < _e1312) && _e1316) {
phi_2179_ = ((((_e1308 - _e1310) + (_e1309 / 4u)) * _e1303) + (((_e1307 - _e1309) + (_e1310 * 4u)) + (_e1309 % 4u)));
} else {
phi_2179_ = ((_e1308 * _e1303) + _e1307);
}
let _e1331 = phi_2179_;
local_6 = bitcast<i32>(_e1331);
let _e1334 = bitcast<i32>((_e1303 * _e1306));
local_7 = _e1334;
let _e1335 = local_7;
let _e1337 = local_6;
let _e1338 = ((3i * _e1335) + _e1337);
let _e1340 = select(_e168, _e1338, (_e1338 < _e168));
let _e1345 = global_3.member[bitcast<u32>(select(0i, _e1340, (_e1340 > 0i)))];
let _e1346 = local_7;
let _e1348 = local_6;
let _e1349 = ((4i * _e1346) + _e1348);
let _e1351 = select(_e168, _e1349, (_e1349 < _e168));
let _e1356 = global_3.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1357 = local_7;
let _e1359 = local_6;
let _e1360 = ((5i * _e1357) + _e1359);
let _e1362 = select(_e168, _e1360, (_e1360 < _e168));
let _e1367 = global_3.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1372 = (((_e1345 * _e1345) + (_e1356 * _e1356)) + (_e1367 * _e1367));
let _e1375 = sqrt(select(0f, _e1372, (_e1372 > 0f)));
let _e1378 = (1f / select(1e-20f, _e1375, (_e1375 > 1e-20f)));
let _e1379 = (_e1345 * _e1378);
let _e1380 = (_e1356 * _e1378);
let _e1381 = (_e1367 * _e1378);
let _e1384 = global_2.member.member_21.member_4;
let _e1395 = global_2.member.member_21.member_5;
let _e1406 = global_2.member.member_21.member_6;
let _e1415 = bitcast<u32>(_e1286);
let _e1416 = (_e1415 % 16u);
if ((_e1415 < _e1312) && _e1316) {
phi_2349_ = ((((_e1308 - _e1310) + (_e1416 / 4u)) * _e1303) + (((_e1415 - _e1416) + (_e1310 * 4u)) + (_e1416 % 4u)));
} else {
phi_2349_ = ((_e1308 * _e1303) + _e1415);
}
let _e1432 = phi_2349_;
local_4 = bitcast<i32>(_e1432);
local_5 = _e1334;
let _e1434 = local_5;
let _e1436 = local_4;
let _e1437 = ((3i * _e1434) + _e1436);
let _e1439 = select(_e168, _e1437, (_e1437 < _e168));
let _e1444 = global_3.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1445 = local_5;
let _e1447 = local_4;
let _e1448 = ((4i * _e1445) + _e1447);
let _e1450 = select(_e168, _e1448, (_e1448 < _e168));
let _e1455 = global_3.member[bitcast<u32>(select(0i, _e1450, (_e1450 > 0i)))];
let _e1456 = local_5;
let _e1458 = local_4;
let _e1459 = ((5i * _e1456) + _e1458);
let _e1461 = select(_e168, _e1459, (_e1459 < _e168));
let _e1466 = global_3.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1471 = (((_e1444 * _e1444) + (_e1455 * _e1455)) + (_e1466 * _e1466));
let _e1474 = sqrt(select(0f, _e1471, (_e1471 > 0f)));
let _e1477 = (1f / select(1e-20f, _e1474, (_e1474 > 1e-20f)));
let _e1478 = (_e1444 * _e1477);
let _e1479 = (_e1455 * _e1477);
let _e1480 = (_e1466 * _e1477);
let _e1496 = ((((_e1384.member * _e1379) + (_e1384.member_1 * _e1380)) + (_e1384.member_2 * _e1381)) - (((_e1384.member * _e1478) + (_e1384.member_1 * _e1479)) + (_e1384.member_2 * _e1480)));
let _e1497 = ((((_e1395.member * _e1379) + (_e1395.member_1 * _e1380)) + (_e1395.member_2 * _e1381)) - (((_e1395.member * _e1478) + (_e1395.member_1 * _e1479)) + (_e1395.member_2 * _e1480)));
let _e1498 = ((((_e1406.member * _e1379) + (_e1406.member_1 * _e1380)) + (_e1406.member_2 * _e1381)) - (((_e1406.member * _e1478) + (_e1406.member_1 * _e1479)) + (_e1406.member_2 * _e1480)));
let _e1503 = (((_e1496 * _e1496) + (_e1497 * _e1497)) + (_e1498 * _e1498));
let _e1507 = bitcast<u32>(_e1279);
let _e1508 = bitcast<u32>(_e1300);
let _e1509 = (_e1507 % 16u);
let _e1510 = (_e1508 % 4u);
let _e1511 = (_e1507 < _e1312);
if (_e1511 && (_e1508 < _e1315)) {
phi_2533_ = ((((_e1508 - _e1510) + (_e1509 / 4u)) * _e1303) + (((_e1507 - _e1509) + (_e1510 * 4u)) + (_e1509 % 4u)));
} else {
phi_2533_ = ((_e1508 * _e1303) + _e1507);
}
let _e1527 = phi_2533_;
local_2 = bitcast<i32>(_e1527);
local_3 = _e1334;
let _e1529 = local_3;
let _e1531 = local_2;
let _e1532 = ((3i * _e1529) + _e1531);
let _e1534 = select(_e168, _e1532, (_e1532 < _e168));
let _e1539 = global_3.member[bitcast<u32>(select(0i, _e1534, (_e1534 > 0i)))];
let _e1540 = local_3;
let _e1542 = local_2;
let _e1543 = ((4i * _e1540) + _e1542);
let _e1545 = select(_e168, _e1543, (_e1543 < _e168));
let _e1550 = global_3.member[bitcast<u32>(select(0i, _e1545, (_e1545 > 0i)))];
let _e1551 = local_3;
let _e1553 = local_2;
let _e1554 = ((5i * _e1551) + _e1553);
let _e1556 = select(_e168, _e1554, (_e1554 < _e168));
let _e1561 = global_3.member[bitcast<u32>(select(0i, _e1556, (_e1556 > 0i)))];
let _e1566 = (((_e1539 * _e1539) + (_e1550 * _e1550)) + (_e1561 * _e1561));
let _e1569 = sqrt(select(0f, _e1566, (_e1566 > 0f)));
let _e1572 = (1f / select(1e-20f, _e1569, (_e1569 > 1e-20f)));
let _e1573 = (_e1539 * _e1572);
let _e1574 = (_e1550 * _e1572);
let _e1575 = (_e1561 * _e1572);
let _e1591 = bitcast<u32>(_e1295);
let _e1592 = (_e1591 % 4u);
if (_e1511 && (_e1591 < _e1315)) {
phi_2703_ = ((((_e1591 - _e1592) + (_e1509 / 4u)) * _e1303) + (((_e1507 - _e1509) + (_e1592 * 4u)) + (_e1509 % 4u)));
} else {
phi_2703_ = ((_e1591 * _e1303) + _e1507);
}
let _e1608 = phi_2703_;
local = bitcast<i32>(_e1608);
local_1 = _e1334;
let _e1610 = local_1;
let _e1612 = local;
let _e1613 = ((3i * _e1610) + _e1612);
let _e1615 = select(_e168, _e1613, (_e1613 < _e168));
let _e1620 = global_3.member[bitcast<u32>(select(0i, _e1615, (_e1615 > 0i)))];
let _e1621 = local_1;
let _e1623 = local;
let _e1624 = ((4i * _e1621) + _e1623);
let _e1626 = select(_e168, _e1624, (_e1624 < _e168));
let _e1631 = global_3.member[bitcast<u32>(select(0i, _e1626, (_e1626 > 0i)))];
let _e1632 = local_1;
let _e1634 = local;
let _e1635 = ((5i * _e1632) + _e1634);
let _e1637 = select(_e168, _e1635, (_e1635 < _e168));
let _e1642 = global_3.member[bitcast<u32>(select(0i, _e1637, (_e1637 > 0i)))];
let _e1647 = (((_e1620 * _e1620) + (_e1631 * _e1631)) + (_e1642 * _e1642));
let _e1650 = sqrt(select(0f, _e1647, (_e1647 > 0f)));
let _e1653 = (1f / select(1e-20f, _e1650, (_e1650 > 1e-20f)));
let _e1654 = (_e1620 * _e1653);
let _e1655 = (_e1631 * _e1653);
let _e1656 = (_e1642 * _e1653);
let _e1672 = ((((_e1384.member * _e1573) + (_e1384.member_1 * _e1574)) + (_e1384.member_2 * _e1575)) - (((_e1384.member * _e1654) + (_e1384.member_1 * _e1655)) + (_e1384.member_2 * _e1656)));
let _e1673 = ((((_e1395.member * _e1573) + (_e1395.member_1 * _e1574)) + (_e1395.member_2 * _e1575)) - (((_e1395.member * _e1654) + (_e1395.member_1 * _e1655)) + (_e1395.member_2 * _e1656)));
let _e1674 = ((((_e1406.member * _e1573) + (_e1406.member_1 * _e1574)) + (_e1406.member_2 * _e1575)) - (((_e1406.member * _e1654) + (_e1406.member_1 * _e1655)) + (_e1406.member_2 * _e1656)));
let _e1679 = (((_e1672 * _e1672) + (_e1673 * _e1673)) + (_e1674 * _e1674));
let _e1684 = f32((_e1291 - _e1286));
let _e1687 = (sqrt(select(0f, _e1503, (_e1503 > 0f))) / select(1f, _e1684, (_e1684 > 1f)));
let _e1689 = f32((_e1300 - _e1295));
let _e1692 = (sqrt(select(0f, _e1679, (_e1679 > 0f))) / select(1f, _e1689, (_e1689 > 1f)));
let _e1694 = select(_e1692, _e1687, (_e1687 > _e1692));
let _e1698 = global_2.member.member_21.member;
let _e1702 = global_2.member.member_21.member_7;
let _e1706 = vec3<f32>(_e1702.member, _e1702.member_1, _e1702.member_2);
let _e1710 = global_2.member.member_21.member_8;
if (_e1698 == 0u) {
phi_4297_ = _e1706;
} else {
if (_e1698 == 1u) {
let _e1717 = select(-1f, _e1278, (_e1278 > -1f));
let _e1719 = select(1f, _e1717, (_e1717 < 1f));
if (_e1719 > 0f) {
phi_2912_ = _e1706;
} else {
let _e1724 = global_2.member.member_21.member_9;
phi_2912_ = vec3<f32>(_e1724.member, _e1724.member_1, _e1724.member_2);
}
let _e1730 = phi_2912_;
let _e1739 = bitcast<f32>((bitcast<u32>(_e1719) & 2147483647u));
let _e1742 = sqrt(select(0f, _e1739, (_e1739 > 0f)));
phi_4296_ = vec3<f32>((_e1710.member + ((_e1730.x - _e1710.member) * _e1742)), (_e1710.member_1 + ((_e1730.y - _e1710.member_1) * _e1742)), (_e1710.member_2 + ((_e1730.z - _e1710.member_2) * _e1742)));
} else {
if (_e1698 == 2u) {
let _e1754 = global_2.member.member_21.member_10;
let _e1755 = (_e1694 / _e1754);
let _e1757 = select(1e-4f, _e1755, (_e1755 > 1e-4f));
let _e1760 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
let _e1763 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
let _e1767 = select(_e1763, _e1760, (_e1760 > _e1763));
let _e1770 = (select(_e1763, _e1760, (_e1760 < _e1763)) / select(1.1754944e-38f, _e1767, (_e1767 > 1.1754944e-38f)));
let _e1771 = (_e1770 > 0.41421357f);
let _e1775 = select(_e1770, ((_e1770 - 1f) / (_e1770 + 1f)), _e1771);
let _e1776 = (_e1775 * _e1775);
let _e1791 = (select(0f, 0.7853982f, _e1771) + (_e1775 + ((_e1775 * _e1776) * (-0.33333334f + (_e1776 * (0.2f + (_e1776 * (-0.14285713f + (_e1776 * (0.11111111f + (_e1776 * (-0.09090909f + (_e1776 * 0.0585f)))))))))))));
let _e1794 = select(_e1791, (1.5707964f - _e1791), (_e1763 > _e1760));
let _e1797 = select(_e1794, (3.1415927f - _e1794), (_e1254 < 0f));
let _e1803 = (1f - (_e1278 * _e1278));
let _e1806 = sqrt(select(0f, _e1803, (_e1803 > 0f)));
let _e1809 = (_e1757 / select(1e-3f, _e1806, (_e1806 > 1e-3f)));
let _e1810 = ((select(_e1797, -(_e1797), (_e1266 < 0f)) / _e1754) * 0.5f);
let _e1812 = select(-8e6f, _e1810, (_e1810 > -8e6f));
let _e1814 = select(8e6f, _e1812, (_e1812 < 8e6f));
let _e1821 = select(0i, select(select(i32(_e1814), i32(-2147483648), (_e1814 < -2147483600f)), 2147483647i, (_e1814 > 2147483500f)), (_e1814 == _e1814));
let _e1828 = ((_e1810 - f32((_e1821 - select(0i, 1i, (_e1814 < f32(_e1821)))))) * 2f);
let _e1836 = ((select(select((_e1828 - 2f), (1f - _e1828), (_e1828 < 1.5f)), _e1828, (_e1828 < 0.5f)) * 2f) / _e1809);
let _e1838 = select(-1f, _e1836, (_e1836 > -1f));
let _e1841 = (2f - _e1809);
let _e1843 = select(0f, _e1841, (_e1841 > 0f));
let _e1848 = select(-1f, _e1278, (_e1278 > -1f));
let _e1850 = select(1f, _e1848, (_e1848 < 1f));
let _e1853 = ((1f - _e1850) * (1f + _e1850));
let _e1856 = sqrt(select(0f, _e1853, (_e1853 > 0f)));
let _e1859 = bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u));
let _e1862 = bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u));
let _e1866 = select(_e1862, _e1859, (_e1859 > _e1862));
let _e1869 = (select(_e1862, _e1859, (_e1859 < _e1862)) / select(1.1754944e-38f, _e1866, (_e1866 > 1.1754944e-38f)));
let _e1870 = (_e1869 > 0.41421357f);
let _e1874 = select(_e1869, ((_e1869 - 1f) / (_e1869 + 1f)), _e1870);
let _e1875 = (_e1874 * _e1874);
let _e1890 = (select(0f, 0.7853982f, _e1870) + (_e1874 + ((_e1874 * _e1875) * (-0.33333334f + (_e1875 * (0.2f + (_e1875 * (-0.14285713f + (_e1875 * (0.11111111f + (_e1875 * (-0.09090909f + (_e1875 * 0.0585f)))))))))))));
let _e1893 = select(_e1890, (1.5707964f - _e1890), (_e1862 > _e1859));
let _e1896 = select(_e1893, (3.1415927f - _e1893), (_e1856 < 0f));
let _e1901 = ((select(_e1896, -(_e1896), (_e1850 < 0f)) / _e1754) * 0.5f);
let _e1903 = select(-8e6f, _e1901, (_e1901 > -8e6f));
let _e1905 = select(8e6f, _e1903, (_e1903 < 8e6f));
let _e1912 = select(0i, select(select(i32(_e1905), i32(-2147483648), (_e1905 < -2147483600f)), 2147483647i, (_e1905 > 2147483500f)), (_e1905 == _e1905));
let _e1919 = ((_e1901 - f32((_e1912 - select(0i, 1i, (_e1905 < f32(_e1912)))))) * 2f);
let _e1927 = ((select(select((_e1919 - 2f), (1f - _e1919), (_e1919 < 1.5f)), _e1919, (_e1919 < 0.5f)) * 2f) / _e1757);
let _e1929 = select(-1f, _e1927, (_e1927 > -1f));
let _e1932 = (2f - _e1757);
let _e1934 = select(0f, _e1932, (_e1932 > 0f));
let _e1940 = (0.5f + ((0.5f * (select(1f, _e1838, (_e1838 < 1f)) * select(1f, _e1843, (_e1843 < 1f)))) * (select(1f, _e1929, (_e1929 < 1f)) * select(1f, _e1934, (_e1934 < 1f)))));
phi_4295_ = vec3<f32>((_e1702.member + ((_e1710.member - _e1702.member) * _e1940)), (_e1702.member_1 + ((_e1710.member_1 - _e1702.member_1) * _e1940)), (_e1702.member_2 + ((_e1710.member_2 - _e1702.member_2) * _e1940)));
} else {
let _e1954 = global_2.member.member_21.member_1;
let _e1955 = bitcast<i32>(_e1954);
let _e1960 = global_2.member.member_21.member_3;
let _e1962 = f32(bitcast<i32>(_e1960));
let _e1964 = (2f * 3.1415927f);
let _e1965 = ((_e1694 * f32(_e1955)) / _e1964);
let _e1967 = select(1e-6f, _e1965, (_e1965 > 1e-6f));
let _e1970 = bitcast<u32>(select(1.1754944e-38f, _e1967, (_e1967 > 1.1754944e-38f)));
let _e1971 = (_e1970 & 8388607u);
let _e1973 = select(0u, 1u, (_e1971 > 3474675u));
let _e1984 = bitcast<f32>((_e1971 | ((127u - _e1973) << bitcast<u32>(23i))));
let _e1987 = ((_e1984 - 1f) / (_e1984 + 1f));
let _e1988 = (_e1987 * _e1987);
let _e2003 = (f32(((bitcast<i32>((_e1970 >> bitcast<u32>(23i))) - 127i) + bitcast<i32>(_e1973))) + (((2f * _e1987) + ((_e1987 * _e1988) * (0.6666667f + (_e1988 * (0.4f + (_e1988 * (0.2857143f + (_e1988 * (0.22222222f + (_e1988 * 0.18181819f)))))))))) * 1.442695f));
let _e2004 = (_e1962 - 1f);
let _e2006 = select(0f, _e2003, (_e2003 > 0f));
let _e2008 = select(_e2004, _e2006, (_e2006 < _e2004));
let _e2009 = (_e1962 - 2f);
let _e2011 = select(0f, _e2009, (_e2009 > 0f));
let _e2013 = select(0f, _e2008, (_e2008 > 0f));
let _e2015 = select(_e2011, _e2013, (_e2013 < _e2011));
let _e2022 = select(0i, select(select(i32(_e2015), i32(-2147483648), (_e2015 < -2147483600f)), 2147483647i, (_e2015 > 2147483500f)), (_e2015 == _e2015));
let _e2026 = (_e2022 - select(0i, 1i, (_e2015 < f32(_e2022))));
let _e2029 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
let _e2032 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
let _e2036 = select(_e2032, _e2029, (_e2029 > _e2032));
let _e2039 = (select(_e2032, _e2029, (_e2029 < _e2032)) / select(1.1754944e-38f, _e2036, (_e2036 > 1.1754944e-38f)));
let _e2040 = (_e2039 > 0.41421357f);
let _e2044 = select(_e2039, ((_e2039 - 1f) / (_e2039 + 1f)), _e2040);
let _e2045 = (_e2044 * _e2044);
let _e2060 = (select(0f, 0.7853982f, _e2040) + (_e2044 + ((_e2044 * _e2045) * (-0.33333334f + (_e2045 * (0.2f + (_e2045 * (-0.14285713f + (_e2045 * (0.11111111f + (_e2045 * (-0.09090909f + (_e2045 * 0.0585f)))))))))))));
let _e2063 = select(_e2060, (1.5707964f - _e2060), (_e2032 > _e2029));
let _e2066 = select(_e2063, (3.1415927f - _e2063), (_e1266 < 0f));
let _e2071 = (0.5f - (select(_e2066, -(_e2066), (_e1254 < 0f)) / _e1964));
let _e2073 = select(-1f, _e1278, (_e1278 > -1f));
let _e2075 = select(1f, _e2073, (_e2073 < 1f));
let _e2078 = ((1f - _e2075) * (1f + _e2075));
let _e2081 = sqrt(select(0f, _e2078, (_e2078 > 0f)));
let _e2084 = bitcast<f32>((bitcast<u32>(_e2081) & 2147483647u));
let _e2087 = bitcast<f32>((bitcast<u32>(_e2075) & 2147483647u));
let _e2091 = select(_e2087, _e2084, (_e2084 > _e2087));
let _e2094 = (select(_e2087, _e2084, (_e2084 < _e2087)) / select(1.1754944e-38f, _e2091, (_e2091 > 1.1754944e-38f)));
let _e2095 = (_e2094 > 0.41421357f);
let _e2099 = select(_e2094, ((_e2094 - 1f) / (_e2094 + 1f)), _e2095);
let _e2100 = (_e2099 * _e2099);
let _e2115 = (select(0f, 0.7853982f, _e2095) + (_e2099 + ((_e2099 * _e2100) * (-0.33333334f + (_e2100 * (0.2f + (_e2100 * (-0.14285713f + (_e2100 * (0.11111111f + (_e2100 * (-0.09090909f + (_e2100 * 0.0585f)))))))))))));
let _e2118 = select(_e2115, (1.5707964f - _e2115), (_e2087 > _e2084));
let _e2121 = select(_e2118, (3.1415927f - _e2118), (_e2081 < 0f));
let _e2126 = (0.5f - (select(_e2121, -(_e2121), (_e2075 < 0f)) / 3.1415927f));
let _e2130 = global_2.member.member_21.member_2;
let _e2131 = bitcast<i32>(_e2130);
phi_3514_ = 0i;
phi_3517_ = 0i;
phi_3519_ = _e2131;
phi_3521_ = _e1955;
loop {
let _e2133 = phi_3514_;
let _e2135 = phi_3517_;
let _e2137 = phi_3519_;
let _e2139 = phi_3521_;
local_12 = _e2139;
local_13 = _e2137;
local_14 = _e2139;
local_15 = _e2139;
local_16 = _e2139;
local_17 = _e2139;
local_18 = _e2139;
local_19 = _e2139;
local_20 = _e2137;
local_21 = _e2137;
local_22 = _e2137;
local_23 = _e2137;
local_24 = _e2139;
local_25 = _e2135;
local_26 = _e2139;
local_27 = _e2135;
let _e2140 = (_e2133 < _e2026);
if _e2140 {
if (_e2139 > 1i) {
phi_3536_ = (_e2139 >> bitcast<u32>(1i));
} else {
phi_3536_ = 1i;
}
let _e2147 = phi_3536_;
if (_e2137 > 1i) {
phi_3542_ = (_e2137 >> bitcast<u32>(1i));
} else {
phi_3542_ = 1i;
}
let _e2152 = phi_3542_;
phi_3515_ = (_e2133 + 1i);
phi_3518_ = (_e2135 + (_e2139 * _e2137));
phi_3520_ = _e2152;
phi_3522_ = _e2147;
} else {
phi_3515_ = i32();
phi_3518_ = i32();
phi_3520_ = i32();
phi_3522_ = i32();
}
let _e2155 = phi_3515_;
let _e2157 = phi_3518_;
let _e2159 = phi_3520_;
let _e2161 = phi_3522_;
continue;
continuing {
phi_3514_ = _e2155;
phi_3517_ = _e2157;
phi_3519_ = _e2159;
phi_3521_ = _e2161;
break if !(_e2140);
}
}
let _e2164 = local_12;
let _e2165 = f32(_e2164);
let _e2167 = ((_e2071 * _e2165) - 0.5f);
let _e2169 = local_13;
let _e2170 = f32(_e2169);
let _e2172 = ((_e2126 * _e2170) - 0.5f);
let _e2174 = select(-1f, _e2167, (_e2167 > -1f));
let _e2176 = select(_e2165, _e2174, (_e2174 < _e2165));
let _e2183 = select(0i, select(select(i32(_e2176), i32(-2147483648), (_e2176 < -2147483600f)), 2147483647i, (_e2176 > 2147483500f)), (_e2176 == _e2176));
let _e2187 = (_e2183 - select(0i, 1i, (_e2176 < f32(_e2183))));
let _e2189 = select(-1f, _e2172, (_e2172 > -1f));
let _e2191 = select(_e2170, _e2189, (_e2189 < _e2170));
let _e2198 = select(0i, select(select(i32(_e2191), i32(-2147483648), (_e2191 < -2147483600f)), 2147483647i, (_e2191 > 2147483500f)), (_e2191 == _e2191));
let _e2202 = (_e2198 - select(0i, 1i, (_e2191 < f32(_e2198))));
let _e2204 = (_e2167 - f32(_e2187));
let _e2206 = (_e2172 - f32(_e2202));
let _e2208 = select(0f, _e2206, (_e2206 > 0f));
let _e2210 = select(1f, _e2208, (_e2208 < 1f));
if (_e2187 < 0i) {
let _e2213 = local_14;
phi_3617_ = (_e2187 + _e2213);
} else {
phi_3617_ = _e2187;
}
let _e2216 = phi_3617_;
let _e2218 = local_15;
if (_e2216 >= _e2218) {
let _e2221 = local_16;
phi_3623_ = (_e2216 - _e2221);
} else {
phi_3623_ = _e2216;
}
let _e2224 = phi_3623_;
let _e2225 = (_e2187 + 1i);
if (_e2225 < 0i) {
let _e2228 = local_17;
phi_3630_ = (_e2225 + _e2228);
} else {
phi_3630_ = _e2225;
}
let _e2231 = phi_3630_;
let _e2233 = local_18;
if (_e2231 >= _e2233) {
let _e2236 = local_19;
phi_3636_ = (_e2231 - _e2236);
} else {
phi_3636_ = _e2231;
}
let _e2239 = phi_3636_;
let _e2241 = select(_e2202, 0i, (_e2202 < 0i));
let _e2243 = local_20;
if (_e2241 >= _e2243) {
let _e2246 = local_21;
phi_3647_ = (_e2246 - 1i);
} else {
phi_3647_ = _e2241;
}
let _e2249 = phi_3647_;
let _e2250 = (_e2202 + 1i);
let _e2252 = select(_e2250, 0i, (_e2250 < 0i));
let _e2254 = local_22;
if (_e2252 >= _e2254) {
let _e2257 = local_23;
phi_3659_ = (_e2257 - 1i);
} else {
phi_3659_ = _e2252;
}
let _e2260 = phi_3659_;
let _e2262 = local_24;
let _e2265 = local_25;
let _e2266 = (_e2265 + (_e2249 * _e2262));
let _e2268 = local_26;
let _e2271 = local_27;
let _e2272 = (_e2271 + (_e2260 * _e2268));
let _e2274 = (3i * (_e2266 + _e2224));
let _e2276 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e2278 = select(_e2276, _e2274, (_e2274 < _e2276));
let _e2284 = global_4.member[bitcast<u32>(select(0i, _e2278, (_e2278 > 0i)))];
let _e2285 = (_e2274 + 1i);
let _e2287 = select(_e2276, _e2285, (_e2285 < _e2276));
let _e2293 = global_4.member[bitcast<u32>(select(0i, _e2287, (_e2287 > 0i)))];
let _e2294 = (_e2274 + 2i);
let _e2296 = select(_e2276, _e2294, (_e2294 < _e2276));
let _e2302 = global_4.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2304 = (3i * (_e2266 + _e2239));
let _e2306 = select(_e2276, _e2304, (_e2304 < _e2276));
let _e2312 = global_4.member[bitcast<u32>(select(0i, _e2306, (_e2306 > 0i)))];
let _e2313 = (_e2304 + 1i);
let _e2315 = select(_e2276, _e2313, (_e2313 < _e2276));
let _e2321 = global_4.member[bitcast<u32>(select(0i, _e2315, (_e2315 > 0i)))];
let _e2322 = (_e2304 + 2i);
let _e2324 = select(_e2276, _e2322, (_e2322 < _e2276));
let _e2330 = global_4.member[bitcast<u32>(select(0i, _e2324, (_e2324 > 0i)))];
let _e2332 = (3i * (_e2272 + _e2224));
let _e2334 = select(_e2276, _e2332, (_e2332 < _e2276));
let _e2340 = global_4.member[bitcast<u32>(select(0i, _e2334, (_e2334 > 0i)))];
let _e2341 = (_e2332 + 1i);
let _e2343 = select(_e2276, _e2341, (_e2341 < _e2276));
let _e2349 = global_4.member[bitcast<u32>(select(0i, _e2343, (_e2343 > 0i)))];
let _e2350 = (_e2332 + 2i);
let _e2352 = select(_e2276, _e2350, (_e2350 < _e2276));
let _e2358 = global_4.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2360 = (3i * (_e2272 + _e2239));
let _e2362 = select(_e2276, _e2360, (_e2360 < _e2276));
let _e2368 = global_4.member[bitcast<u32>(select(0i, _e2362, (_e2362 > 0i)))];
let _e2369 = (_e2360 + 1i);
let _e2371 = select(_e2276, _e2369, (_e2369 < _e2276));
let _e2377 = global_4.member[bitcast<u32>(select(0i, _e2371, (_e2371 > 0i)))];
let _e2378 = (_e2360 + 2i);
let _e2380 = select(_e2276, _e2378, (_e2378 < _e2276));
let _e2386 = global_4.member[bitcast<u32>(select(0i, _e2380, (_e2380 > 0i)))];
let _e2393 = (_e2284 + ((_e2312 - _e2284) * _e2204));
let _e2394 = (_e2293 + ((_e2321 - _e2293) * _e2204));
let _e2395 = (_e2302 + ((_e2330 - _e2302) * _e2204));
let _e2411 = (_e2393 + (((_e2340 + ((_e2368 - _e2340) * _e2204)) - _e2393) * _e2210));
let _e2412 = (_e2394 + (((_e2349 + ((_e2377 - _e2349) * _e2204)) - _e2394) * _e2210));
let _e2413 = (_e2395 + (((_e2358 + ((_e2386 - _e2358) * _e2204)) - _e2395) * _e2210));
phi_3895_ = 0i;
phi_3898_ = 0i;
phi_3900_ = _e2131;
phi_3902_ = _e1955;
loop {
let _e2416 = phi_3895_;
let _e2418 = phi_3898_;
let _e2420 = phi_3900_;
let _e2422 = phi_3902_;
local_28 = _e2422;
local_29 = _e2420;
local_30 = _e2422;
local_31 = _e2422;
local_32 = _e2422;
local_33 = _e2422;
local_34 = _e2422;
local_35 = _e2422;
local_36 = _e2420;
local_37 = _e2420;
local_38 = _e2420;
local_39 = _e2420;
local_40 = _e2422;
local_41 = _e2418;
local_42 = _e2422;
local_43 = _e2418;
let _e2423 = (_e2416 < (_e2026 + 1i));
if _e2423 {
if (_e2422 > 1i) {
phi_3917_ = (_e2422 >> bitcast<u32>(1i));
} else {
phi_3917_ = 1i;
}
let _e2430 = phi_3917_;
if (_e2420 > 1i) {
phi_3923_ = (_e2420 >> bitcast<u32>(1i));
} else {
phi_3923_ = 1i;
}
let _e2435 = phi_3923_;
phi_3896_ = (_e2416 + 1i);
phi_3899_ = (_e2418 + (_e2422 * _e2420));
phi_3901_ = _e2435;
phi_3903_ = _e2430;
} else {
phi_3896_ = i32();
phi_3899_ = i32();
phi_3901_ = i32();
phi_3903_ = i32();
}
let _e2438 = phi_3896_;
let _e2440 = phi_3899_;
let _e2442 = phi_3901_;
let _e2444 = phi_3903_;
continue;
continuing {
phi_3895_ = _e2438;
phi_3898_ = _e2440;
phi_3900_ = _e2442;
phi_3902_ = _e2444;
break if !(_e2423);
}
}
let _e2447 = local_28;
let _e2448 = f32(_e2447);
let _e2450 = ((_e2071 * _e2448) - 0.5f);
let _e2452 = local_29;
let _e2453 = f32(_e2452);
let _e2455 = ((_e2126 * _e2453) - 0.5f);
let _e2457 = select(-1f, _e2450, (_e2450 > -1f));
let _e2459 = select(_e2448, _e2457, (_e2457 < _e2448));
let _e2466 = select(0i, select(select(i32(_e2459), i32(-2147483648), (_e2459 < -2147483600f)), 2147483647i, (_e2459 > 2147483500f)), (_e2459 == _e2459));
let _e2470 = (_e2466 - select(0i, 1i, (_e2459 < f32(_e2466))));
let _e2472 = select(-1f, _e2455, (_e2455 > -1f));
let _e2474 = select(_e2453, _e2472, (_e2472 < _e2453));
let _e2481 = select(0i, select(select(i32(_e2474), i32(-2147483648), (_e2474 < -2147483600f)), 2147483647i, (_e2474 > 2147483500f)), (_e2474 == _e2474));
let _e2485 = (_e2481 - select(0i, 1i, (_e2474 < f32(_e2481))));
let _e2487 = (_e2450 - f32(_e2470));
let _e2489 = (_e2455 - f32(_e2485));
let _e2491 = select(0f, _e2489, (_e2489 > 0f));
let _e2493 = select(1f, _e2491, (_e2491 < 1f));
if (_e2470 < 0i) {
let _e2496 = local_30;
phi_3998_ = (_e2470 + _e2496);
} else {
phi_3998_ = _e2470;
}
let _e2499 = phi_3998_;
let _e2501 = local_31;
if (_e2499 >= _e2501) {
let _e2504 = local_32;
phi_4004_ = (_e2499 - _e2504);
} else {
phi_4004_ = _e2499;
}
let _e2507 = phi_4004_;
let _e2508 = (_e2470 + 1i);
if (_e2508 < 0i) {
let _e2511 = local_33;
phi_4011_ = (_e2508 + _e2511);
} else {
phi_4011_ = _e2508;
}
let _e2514 = phi_4011_;
let _e2516 = local_34;
if (_e2514 >= _e2516) {
let _e2519 = local_35;
phi_4017_ = (_e2514 - _e2519);
} else {
phi_4017_ = _e2514;
}
let _e2522 = phi_4017_;
let _e2524 = select(_e2485, 0i, (_e2485 < 0i));
let _e2526 = local_36;
if (_e2524 >= _e2526) {
let _e2529 = local_37;
phi_4028_ = (_e2529 - 1i);
} else {
phi_4028_ = _e2524;
}
let _e2532 = phi_4028_;
let _e2533 = (_e2485 + 1i);
let _e2535 = select(_e2533, 0i, (_e2533 < 0i));
let _e2537 = local_38;
if (_e2535 >= _e2537) {
let _e2540 = local_39;
phi_4040_ = (_e2540 - 1i);
} else {
phi_4040_ = _e2535;
}
let _e2543 = phi_4040_;
let _e2545 = local_40;
let _e2548 = local_41;
let _e2549 = (_e2548 + (_e2532 * _e2545));
let _e2551 = local_42;
let _e2554 = local_43;
let _e2555 = (_e2554 + (_e2543 * _e2551));
let _e2557 = (3i * (_e2549 + _e2507));
let _e2559 = select(_e2276, _e2557, (_e2557 < _e2276));
let _e2565 = global_4.member[bitcast<u32>(select(0i, _e2559, (_e2559 > 0i)))];
let _e2566 = (_e2557 + 1i);
let _e2568 = select(_e2276, _e2566, (_e2566 < _e2276));
let _e2574 = global_4.member[bitcast<u32>(select(0i, _e2568, (_e2568 > 0i)))];
let _e2575 = (_e2557 + 2i);
let _e2577 = select(_e2276, _e2575, (_e2575 < _e2276));
let _e2583 = global_4.member[bitcast<u32>(select(0i, _e2577, (_e2577 > 0i)))];
let _e2585 = (3i * (_e2549 + _e2522));
let _e2587 = select(_e2276, _e2585, (_e2585 < _e2276));
let _e2593 = global_4.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2594 = (_e2585 + 1i);
let _e2596 = select(_e2276, _e2594, (_e2594 < _e2276));
let _e2602 = global_4.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2603 = (_e2585 + 2i);
let _e2605 = select(_e2276, _e2603, (_e2603 < _e2276));
let _e2611 = global_4.member[bitcast<u32>(select(0i, _e2605, (_e2605 > 0i)))];
let _e2613 = (3i * (_e2555 + _e2507));
let _e2615 = select(_e2276, _e2613, (_e2613 < _e2276));
let _e2621 = global_4.member[bitcast<u32>(select(0i, _e2615, (_e2615 > 0i)))];
let _e2622 = (_e2613 + 1i);
let _e2624 = select(_e2276, _e2622, (_e2622 < _e2276));
let _e2630 = global_4.member[bitcast<u32>(select(0i, _e2624, (_e2624 > 0i)))];
let _e2631 = (_e2613 + 2i);
let _e2633 = select(_e2276, _e2631, (_e2631 < _e2276));
let _e2639 = global_4.member[bitcast<u32>(select(0i, _e2633, (_e2633 > 0i)))];
let _e2641 = (3i * (_e2555 + _e2522));
let _e2643 = select(_e2276, _e2641, (_e2641 < _e2276));
let _e2649 = global_4.member[bitcast<u32>(select(0i, _e2643, (_e2643 > 0i)))];
let _e2650 = (_e2641 + 1i);
let _e2652 = select(_e2276, _e2650, (_e2650 < _e2276));
let _e2658 = global_4.member[bitcast<u32>(select(0i, _e2652, (_e2652 > 0i)))];
let _e2659 = (_e2641 + 2i);
let _e2661 = select(_e2276, _e2659, (_e2659 < _e2276));
let _e2667 = global_4.member[bitcast<u32>(select(0i, _e2661, (_e2661 > 0i)))];
let _e2674 = (_e2565 + ((_e2593 - _e2565) * _e2487));
let _e2675 = (_e2574 + ((_e2602 - _e2574) * _e2487));
let _e2676 = (_e2583 + ((_e2611 - _e2583) * _e2487));
let _e2699 = (_e2008 - f32(_e2026));
let _e2701 = select(0f, _e2699, (_e2699 > 0f));
let _e2703 = select(1f, _e2701, (_e2701 < 1f));
let _e2713 = global_2.member.member_21.member_11;
phi_4295_ = vec3<f32>(((_e2411 + (((_e2674 + (((_e2621 + ((_e2649 - _e2621) * _e2487)) - _e2674) * _e2493)) - _e2411) * _e2703)) * _e2713), ((_e2412 + (((_e2675 + (((_e2630 + ((_e2658 - _e2630) * _e2487)) - _e2675) * _e2493)) - _e2412) * _e2703)) * _e2713), ((_e2413 + (((_e2676 + (((_e2639 + ((_e2667 - _e2639) * _e2487)) - _e2676) * _e2493)) - _e2413) * _e2703)) * _e2713));
}
let _e2719 = phi_4295_;
phi_4296_ = _e2719;
}
let _e2721 = phi_4296_;
phi_4297_ = _e2721;
}
let _e2723 = phi_4297_;
let _e2727 = global_2.member.member_21.member_12;
let _e2734 = (_e1194 * _e2727);
let _e2746 = (1f - ((_e1194 * ((_e241 + _e252) + _e263)) * (1f / 3f)));
global_1.member[_e128] = ((_e186 + ((_e241 * (select(_e445.member, _e434.member, _e423) * (((_e1113.member.x * _e1135) * _e1161) + _e1144.member))) * _e1179)) + ((_e241 * _e2723.x) * _e2734));
global_1.member[(_e126 + _e128)] = ((_e197 + ((_e252 * (select(_e445.member_1, _e434.member_1, _e423) * (((_e1113.member.y * _e1135) * _e1161) + _e1144.member_1))) * _e1179)) + ((_e252 * _e2723.y) * _e2734));
global_1.member[((2u * _e126) + _e128)] = ((_e208 + ((_e263 * (select(_e445.member_2, _e434.member_2, _e423) * (((_e1113.member.z * _e1135) * _e1161) + _e1144.member_2))) * _e1179)) + ((_e263 * _e2723.z) * _e2734));
global_1.member[((3u * _e126) + _e128)] = (_e2746 + ((1f - _e2746) * _e2727));
global_1.member[((4u * _e126) + _e128)] = _e1189;
global_1.member[((5u * _e126) + _e128)] = _e241;
global_1.member[((6u * _e126) + _e128)] = _e252;
global_1.member[((7u * _e126) + _e128)] = _e263;
global_1.member[((8u * _e126) + _e128)] = ((_e230 + (_e1179 * (_e353 + (_e310 * _e422)))) / select(1e-12f, _e1189, (_e1189 > 1e-12f)));
global_1.member[((9u * _e126) + _e128)] = _e308;
global_1.member[((10u * _e126) + _e128)] = _e309;
global_1.member[((11u * _e126) + _e128)] = -(_e310);
global_1.member[((12u * _e126) + _e128)] = select(_e351, _e469, _e1174);
global_1.member[((13u * _e126) + _e128)] = select(_e352, _e470, _e1174);
global_1.member[((14u * _e126) + _e128)] = -(select(_e353, _e471, _e1174));
global_1.member[((15u * _e126) + _e128)] = select(select(_e175, 2f, (_e175 == 4f)), 1f, _e1174);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
