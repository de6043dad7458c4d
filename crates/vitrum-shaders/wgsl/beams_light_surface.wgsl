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
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_26 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(7)
var<storage, read_write> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: u32;
var local_4: type_17;
var local_5: u32;
var local_6: type_24;
var local_7: i32;
var local_8: i32;
var phi_2357_: type_26;
var phi_2421_: bool;
var phi_2453_: f32;
var phi_2494_: vec3<f32>;
var phi_2497_: u32;
var phi_2517_: u32;
var phi_2518_: u32;
var phi_2530_: u32;
var phi_2531_: u32;
var local_9: u32;
var local_10: u32;
var phi_2548_: u32;
var phi_2549_: u32;
var phi_2561_: u32;
var phi_2562_: u32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var phi_2587_: u32;
var phi_2588_: u32;
var local_14: u32;
var local_15: u32;
var phi_2605_: u32;
var phi_2606_: u32;
var local_16: u32;
var local_17: u32;
var phi_2628_: u32;
var phi_2629_: u32;
var phi_2641_: u32;
var phi_2642_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_2678_: u32;
var local_21: u32;
var phi_2691_: vec3<f32>;
var phi_2694_: type_17;
var phi_4467_: vec3<f32>;
var phi_4468_: vec3<f32>;
var phi_4469_: bool;
var phi_4473_: vec3<f32>;
var phi_4474_: bool;
var phi_4478_: vec3<f32>;
var phi_4479_: bool;
var phi_4495_: vec3<f32>;
var phi_4503_: type_17;
var phi_4504_: type_17;
var phi_4525_: vec3<f32>;
var phi_4526_: type_17;
var phi_2692_: vec3<f32>;
var phi_2695_: type_17;
var phi_2495_: vec3<f32>;
var phi_2498_: u32;
var local_22: vec3<f32>;
var local_23: vec3<f32>;
var local_24: vec3<f32>;
var phi_4898_: array<f32, 18>;
var local_25: type_17;
var local_26: vec3<f32>;
let _e116 = global;
let _e127 = arrayLength((&global_6.member));
let _e136 = global_1.member.member;
if (_e116.x < _e136.member) {
if (_e116.y < _e136.member_1) {
let _e143 = (_e136.member * _e136.member_1);
let _e145 = ((_e116.y * _e136.member) + _e116.x);
let _e146 = bitcast<i32>(_e145);
let _e148 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e150 = select(_e148, _e146, (_e146 < _e148));
let _e156 = global_5.member[bitcast<u32>(select(0i, _e150, (_e150 > 0i)))];
let _e157 = (_e143 + _e145);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e148, _e158, (_e158 < _e148));
let _e166 = global_5.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((2u * _e143) + _e145);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e148, _e169, (_e169 < _e148));
let _e177 = global_5.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((3u * _e143) + _e145);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e148, _e180, (_e180 < _e148));
let _e188 = global_5.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((4u * _e143) + _e145);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e148, _e191, (_e191 < _e148));
let _e199 = global_5.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((5u * _e143) + _e145);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e148, _e202, (_e202 < _e148));
let _e210 = global_5.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((6u * _e143) + _e145);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e148, _e213, (_e213 < _e148));
let _e221 = global_5.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((7u * _e143) + _e145);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e148, _e224, (_e224 < _e148));
let _e232 = global_5.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((8u * _e143) + _e145);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e148, _e235, (_e235 < _e148));
let _e243 = global_5.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((9u * _e143) + _e145);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e148, _e246, (_e246 < _e148));
let _e254 = global_5.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((10u * _e143) + _e145);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e148, _e257, (_e257 < _e148));
let _e265 = global_5.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((11u * _e143) + _e145);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e148, _e268, (_e268 < _e148));
let _e276 = global_5.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((12u * _e143) + _e145);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e148, _e279, (_e279 < _e148));
let _e287 = global_5.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((13u * _e143) + _e145);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e148, _e290, (_e290 < _e148));
let _e298 = global_5.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((14u * _e143) + _e145);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e148, _e301, (_e301 < _e148));
let _e309 = global_5.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((15u * _e143) + _e145);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e148, _e312, (_e312 < _e148));
let _e320 = global_5.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((16u * _e143) + _e145);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e148, _e323, (_e323 < _e148));
let _e331 = global_5.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((17u * _e143) + _e145);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e148, _e334, (_e334 < _e148));
let _e342 = global_5.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e347 = global_1.member.member.member;
let _e351 = global_1.member.member.member_1;
let _e352 = (_e347 * _e351);
local_7 = bitcast<i32>(_e352);
let _e355 = ((_e116.y * _e347) + _e116.x);
let _e356 = bitcast<i32>(_e355);
local_8 = _e356;
let _e357 = local_7;
let _e359 = local_8;
let _e360 = ((29i * _e357) + _e359);
let _e362 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e364 = select(_e362, _e360, (_e360 < _e362));
let _e369 = global_2.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e371 = local_7;
let _e373 = local_8;
let _e374 = ((36i * _e371) + _e373);
let _e376 = select(_e362, _e374, (_e374 < _e362));
let _e381 = global_2.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e392 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e369 == 2f) && (select(0i, select(select(i32(_e381), i32(-2147483648), (_e381 < -2147483600f)), 2147483647i, (_e381 > 2147483500f)), (_e381 == _e381)) == (bitcast<i32>(_e392) + 1i)))) > 1u) {
let _e400 = select(_e362, _e356, (_e356 < _e362));
let _e406 = global_2.member[bitcast<u32>(select(0i, _e400, (_e400 > 0i)))];
let _e408 = bitcast<i32>((_e352 + _e355));
let _e410 = select(_e362, _e408, (_e408 < _e362));
let _e416 = global_2.member[bitcast<u32>(select(0i, _e410, (_e410 > 0i)))];
let _e419 = bitcast<i32>(((2u * _e352) + _e355));
let _e421 = select(_e362, _e419, (_e419 < _e362));
let _e427 = global_2.member[bitcast<u32>(select(0i, _e421, (_e421 > 0i)))];
let _e430 = bitcast<i32>(((3u * _e352) + _e355));
let _e432 = select(_e362, _e430, (_e430 < _e362));
let _e438 = global_2.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e441 = bitcast<i32>(((4u * _e352) + _e355));
let _e443 = select(_e362, _e441, (_e441 < _e362));
let _e449 = global_2.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e452 = bitcast<i32>(((5u * _e352) + _e355));
let _e454 = select(_e362, _e452, (_e452 < _e362));
let _e460 = global_2.member[bitcast<u32>(select(0i, _e454, (_e454 > 0i)))];
let _e463 = bitcast<i32>(((6u * _e352) + _e355));
let _e465 = select(_e362, _e463, (_e463 < _e362));
let _e471 = global_2.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e474 = bitcast<i32>(((7u * _e352) + _e355));
let _e476 = select(_e362, _e474, (_e474 < _e362));
let _e482 = global_2.member[bitcast<u32>(select(0i, _e476, (_e476 > 0i)))];
let _e485 = bitcast<i32>(((8u * _e352) + _e355));
let _e487 = select(_e362, _e485, (_e485 < _e362));
let _e493 = global_2.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e496 = bitcast<i32>(((9u * _e352) + _e355));
let _e498 = select(_e362, _e496, (_e496 < _e362));
let _e504 = global_2.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e507 = bitcast<i32>(((10u * _e352) + _e355));
let _e509 = select(_e362, _e507, (_e507 < _e362));
let _e515 = global_2.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e518 = bitcast<i32>(((11u * _e352) + _e355));
let _e520 = select(_e362, _e518, (_e518 < _e362));
let _e526 = global_2.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e529 = bitcast<i32>(((12u * _e352) + _e355));
let _e531 = select(_e362, _e529, (_e529 < _e362));
let _e537 = global_2.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e540 = bitcast<i32>(((13u * _e352) + _e355));
let _e542 = select(_e362, _e540, (_e540 < _e362));
let _e548 = global_2.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e551 = bitcast<i32>(((14u * _e352) + _e355));
let _e553 = select(_e362, _e551, (_e551 < _e362));
let _e559 = global_2.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e562 = bitcast<i32>(((15u * _e352) + _e355));
let _e564 = select(_e362, _e562, (_e562 < _e362));
let _e570 = global_2.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e573 = bitcast<i32>(((16u * _e352) + _e355));
let _e575 = select(_e362, _e573, (_e573 < _e362));
let _e581 = global_2.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e584 = bitcast<i32>(((17u * _e352) + _e355));
let _e586 = select(_e362, _e584, (_e584 < _e362));
let _e592 = global_2.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e595 = bitcast<i32>(((18u * _e352) + _e355));
let _e597 = select(_e362, _e595, (_e595 < _e362));
let _e603 = global_2.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e606 = bitcast<i32>(((19u * _e352) + _e355));
let _e608 = select(_e362, _e606, (_e606 < _e362));
let _e614 = global_2.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e617 = bitcast<i32>(((20u * _e352) + _e355));
let _e619 = select(_e362, _e617, (_e617 < _e362));
let _e625 = global_2.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e628 = bitcast<i32>(((23u * _e352) + _e355));
let _e630 = select(_e362, _e628, (_e628 < _e362));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e630, (_e630 > 0i)))];
let _e639 = bitcast<i32>(((24u * _e352) + _e355));
let _e641 = select(_e362, _e639, (_e639 < _e362));
let _e647 = global_2.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e650 = bitcast<i32>(((30u * _e352) + _e355));
let _e652 = select(_e362, _e650, (_e650 < _e362));
let _e658 = global_2.member[bitcast<u32>(select(0i, _e652, (_e652 > 0i)))];
let _e665 = select(0i, select(select(i32(_e636), i32(-2147483648), (_e636 < -2147483600f)), 2147483647i, (_e636 > 2147483500f)), (_e636 == _e636));
let _e673 = (select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < -2147483600f)), 2147483647i, (_e658 > 2147483500f)), (_e658 == _e658)) == 0i);
let _e681 = global_1.member.member_1.member;
let _e687 = global_1.member.member_1.member_1;
let _e697 = global_1.member.member_2.member;
let _e698 = (((((f32(bitcast<i32>(_e116.x)) + 0.5f) / f32(bitcast<i32>(_e681))) * 2f) - 1f) * _e697);
let _e706 = global_1.member.member_2.member_1;
let _e707 = ((1f - (((f32(bitcast<i32>(_e116.y)) + 0.5f) / f32(bitcast<i32>(_e687))) * 2f)) * _e706);
let _e710 = global_1.member.member_3;
let _e719 = global_1.member.member_4;
let _e732 = global_1.member.member_2.member_3;
let _e733 = (_e732 != 0u);
let _e736 = global_1.member.member_6;
let _e743 = select(_e736.member, (_e736.member + ((_e710.member * _e698) + (_e719.member * _e707))), _e733);
let _e744 = select(_e736.member_1, (_e736.member_1 + ((_e710.member_1 * _e698) + (_e719.member_1 * _e707))), _e733);
let _e745 = select(_e736.member_2, (_e736.member_2 + ((_e710.member_2 * _e698) + (_e719.member_2 * _e707))), _e733);
let _e755 = select(_e406, _e743, _e673);
let _e756 = select(_e416, _e744, _e673);
let _e757 = select(_e427, _e745, _e673);
let _e758 = (select(0f, ((((_e406 - _e743) * _e438) + ((_e416 - _e744) * _e449)) + ((_e427 - _e745) * _e460)), _e673) + _e647);
let _e763 = select(_e758, 0f, (_e665 == -1i));
let _e767 = (_e755 + (_e438 * _e763));
let _e768 = (_e756 + (_e449 * _e763));
let _e769 = (_e757 + (_e460 * _e763));
let _e770 = vec3<f32>(_e767, _e768, _e769);
let _e773 = global_1.member.member_17;
let _e776 = (_e665 >= 0i);
if _e776 {
let _e821 = (_e665 * 19i);
let _e823 = (bitcast<i32>(_e127) - 1i);
let _e825 = select(_e823, _e821, (_e821 < _e823));
let _e831 = global_6.member[bitcast<u32>(select(0i, _e825, (_e825 > 0i)))];
let _e832 = (_e821 + 1i);
let _e834 = select(_e823, _e832, (_e832 < _e823));
let _e840 = global_6.member[bitcast<u32>(select(0i, _e834, (_e834 > 0i)))];
let _e841 = (_e821 + 2i);
let _e843 = select(_e823, _e841, (_e841 < _e823));
let _e849 = global_6.member[bitcast<u32>(select(0i, _e843, (_e843 > 0i)))];
let _e850 = (_e821 + 3i);
let _e852 = select(_e823, _e850, (_e850 < _e823));
let _e858 = global_6.member[bitcast<u32>(select(0i, _e852, (_e852 > 0i)))];
let _e859 = (_e821 + 4i);
let _e861 = select(_e823, _e859, (_e859 < _e823));
let _e867 = global_6.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
let _e868 = (_e821 + 5i);
let _e870 = select(_e823, _e868, (_e868 < _e823));
let _e876 = global_6.member[bitcast<u32>(select(0i, _e870, (_e870 > 0i)))];
let _e877 = (_e821 + 6i);
let _e879 = select(_e823, _e877, (_e877 < _e823));
let _e885 = global_6.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e886 = (_e821 + 7i);
let _e888 = select(_e823, _e886, (_e886 < _e823));
let _e894 = global_6.member[bitcast<u32>(select(0i, _e888, (_e888 > 0i)))];
let _e895 = (_e821 + 8i);
let _e897 = select(_e823, _e895, (_e895 < _e823));
let _e903 = global_6.member[bitcast<u32>(select(0i, _e897, (_e897 > 0i)))];
let _e904 = (_e858 - _e831);
let _e905 = (_e867 - _e840);
let _e906 = (_e876 - _e849);
let _e907 = (_e885 - _e831);
let _e908 = (_e894 - _e840);
let _e909 = (_e903 - _e849);
let _e912 = ((_e905 * _e909) - (_e906 * _e908));
let _e915 = ((_e906 * _e907) - (_e904 * _e909));
let _e918 = ((_e904 * _e908) - (_e905 * _e907));
let _e919 = (_e858 - _e767);
let _e920 = (_e867 - _e768);
let _e921 = (_e876 - _e769);
let _e922 = (_e885 - _e767);
let _e923 = (_e894 - _e768);
let _e924 = (_e903 - _e769);
let _e938 = (((((_e920 * _e924) - (_e921 * _e923)) * _e912) + (((_e921 * _e922) - (_e919 * _e924)) * _e915)) + (((_e919 * _e923) - (_e920 * _e922)) * _e918));
let _e940 = select(0f, _e938, (_e938 > 0f));
let _e941 = (_e831 - _e767);
let _e942 = (_e840 - _e768);
let _e943 = (_e849 - _e769);
let _e957 = (((((_e923 * _e943) - (_e924 * _e942)) * _e912) + (((_e924 * _e941) - (_e922 * _e943)) * _e915)) + (((_e922 * _e942) - (_e923 * _e941)) * _e918));
let _e959 = select(0f, _e957, (_e957 > 0f));
let _e973 = (((((_e942 * _e921) - (_e943 * _e920)) * _e912) + (((_e943 * _e919) - (_e941 * _e921)) * _e915)) + (((_e941 * _e920) - (_e942 * _e919)) * _e918));
let _e975 = select(0f, _e973, (_e973 > 0f));
let _e977 = ((_e940 + _e959) + _e975);
let _e979 = select(1e-30f, _e977, (_e977 > 1e-30f));
let _e980 = (_e940 / _e979);
let _e981 = (_e959 / _e979);
let _e982 = (_e975 / _e979);
let _e987 = (((_e912 * _e912) + (_e915 * _e915)) + (_e918 * _e918));
let _e990 = sqrt(select(0f, _e987, (_e987 > 0f)));
let _e993 = (1f / select(1e-20f, _e990, (_e990 > 1e-20f)));
let _e998 = (_e821 + 9i);
let _e1000 = select(_e823, _e998, (_e998 < _e823));
let _e1006 = global_6.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1007 = (_e821 + 10i);
let _e1009 = select(_e823, _e1007, (_e1007 < _e823));
let _e1015 = global_6.member[bitcast<u32>(select(0i, _e1009, (_e1009 > 0i)))];
let _e1016 = (_e821 + 11i);
let _e1018 = select(_e823, _e1016, (_e1016 < _e823));
let _e1024 = global_6.member[bitcast<u32>(select(0i, _e1018, (_e1018 > 0i)))];
let _e1028 = (_e821 + 12i);
let _e1030 = select(_e823, _e1028, (_e1028 < _e823));
let _e1036 = global_6.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1037 = (_e821 + 13i);
let _e1039 = select(_e823, _e1037, (_e1037 < _e823));
let _e1045 = global_6.member[bitcast<u32>(select(0i, _e1039, (_e1039 > 0i)))];
let _e1046 = (_e821 + 14i);
let _e1048 = select(_e823, _e1046, (_e1046 < _e823));
let _e1054 = global_6.member[bitcast<u32>(select(0i, _e1048, (_e1048 > 0i)))];
let _e1061 = (_e821 + 15i);
let _e1063 = select(_e823, _e1061, (_e1061 < _e823));
let _e1069 = global_6.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1070 = (_e821 + 16i);
let _e1072 = select(_e823, _e1070, (_e1070 < _e823));
let _e1078 = global_6.member[bitcast<u32>(select(0i, _e1072, (_e1072 > 0i)))];
let _e1079 = (_e821 + 17i);
let _e1081 = select(_e823, _e1079, (_e1079 < _e823));
let _e1087 = global_6.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1091 = (((_e1006 * _e980) + (_e1036 * _e981)) + (_e1069 * _e982));
let _e1092 = (((_e1015 * _e980) + (_e1045 * _e981)) + (_e1078 * _e982));
let _e1093 = (((_e1024 * _e980) + (_e1054 * _e981)) + (_e1087 * _e982));
let _e1098 = (((_e1091 * _e1091) + (_e1092 * _e1092)) + (_e1093 * _e1093));
let _e1101 = sqrt(select(0f, _e1098, (_e1098 > 0f)));
let _e1104 = (1f / select(1e-20f, _e1101, (_e1101 > 1e-20f)));
let _e1109 = (_e821 + 18i);
let _e1111 = select(_e823, _e1109, (_e1109 < _e823));
let _e1117 = global_6.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1126 = (select(select(0i, select(select(i32(_e1117), i32(-2147483648), (_e1117 < -2147483600f)), 2147483647i, (_e1117 > 2147483500f)), (_e1117 == _e1117)), _e665, ((_e773 & 1u) != 0u)) * 10i);
let _e1128 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1130 = select(_e1128, _e1126, (_e1126 < _e1128));
let _e1136 = global_7.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1137 = (_e1126 + 1i);
let _e1139 = select(_e1128, _e1137, (_e1137 < _e1128));
let _e1145 = global_7.member[bitcast<u32>(select(0i, _e1139, (_e1139 > 0i)))];
let _e1146 = (_e1126 + 2i);
let _e1148 = select(_e1128, _e1146, (_e1146 < _e1128));
let _e1154 = global_7.member[bitcast<u32>(select(0i, _e1148, (_e1148 > 0i)))];
let _e1158 = (_e1126 + 3i);
let _e1160 = select(_e1128, _e1158, (_e1158 < _e1128));
let _e1166 = global_7.member[bitcast<u32>(select(0i, _e1160, (_e1160 > 0i)))];
let _e1167 = (_e1126 + 4i);
let _e1169 = select(_e1128, _e1167, (_e1167 < _e1128));
let _e1175 = global_7.member[bitcast<u32>(select(0i, _e1169, (_e1169 > 0i)))];
let _e1176 = (_e1126 + 5i);
let _e1178 = select(_e1128, _e1176, (_e1176 < _e1128));
let _e1184 = global_7.member[bitcast<u32>(select(0i, _e1178, (_e1178 > 0i)))];
let _e1191 = (_e1126 + 6i);
let _e1193 = select(_e1128, _e1191, (_e1191 < _e1128));
let _e1199 = global_7.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1200 = (_e1126 + 7i);
let _e1202 = select(_e1128, _e1200, (_e1200 < _e1128));
let _e1208 = global_7.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1209 = (_e1126 + 8i);
let _e1211 = select(_e1128, _e1209, (_e1209 < _e1128));
let _e1217 = global_7.member[bitcast<u32>(select(0i, _e1211, (_e1211 > 0i)))];
let _e1225 = (_e1126 + 9i);
let _e1227 = select(_e1128, _e1225, (_e1225 < _e1128));
let _e1233 = global_7.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
phi_2357_ = type_26(_e770, vec3<f32>((_e912 * _e993), (_e915 * _e993), (_e918 * _e993)), vec3<f32>((_e1091 * _e1104), (_e1092 * _e1104), (_e1093 * _e1104)), vec3<f32>((((_e1136 * _e980) + (_e1166 * _e981)) + (_e1199 * _e982)), (((_e1145 * _e980) + (_e1175 * _e981)) + (_e1208 * _e982)), (((_e1154 * _e980) + (_e1184 * _e981)) + (_e1217 * _e982))), _e1233, true);
} else {
let _e777 = (_e665 == -3i);
let _e783 = global_1.member.member_14.member_1.member.member;
let _e788 = global_1.member.member_14.member_1.member_1;
let _e794 = global_1.member.member_14.member.member.member;
let _e799 = global_1.member.member_14.member.member_1;
let _e809 = vec3<f32>(select(_e794.member, _e783.member, _e777), select(_e794.member_1, _e783.member_1, _e777), select(_e794.member_2, _e783.member_2, _e777));
phi_2357_ = type_26(_e770, _e809, _e809, vec3<f32>(select(_e799.member, _e788.member, _e777), select(_e799.member_1, _e788.member_1, _e777), select(_e799.member_2, _e788.member_2, _e777)), 0f, false);
}
let _e1236 = phi_2357_;
let _e1239 = ((select(0i, _e665, _e776) * 19i) + 18i);
let _e1241 = (bitcast<i32>(_e127) - 1i);
let _e1243 = select(_e1241, _e1239, (_e1239 < _e1241));
let _e1249 = global_6.member[bitcast<u32>(select(0i, _e1243, (_e1243 > 0i)))];
let _e1256 = select(0i, select(select(i32(_e1249), i32(-2147483648), (_e1249 < -2147483600f)), 2147483647i, (_e1249 > 2147483500f)), (_e1249 == _e1249));
let _e1257 = (_e1256 * 4i);
let _e1259 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1261 = select(_e1259, _e1257, (_e1257 < _e1259));
let _e1267 = global_8.member[bitcast<u32>(select(0i, _e1261, (_e1261 > 0i)))];
if _e776 {
phi_2421_ = (select(_e1267, 1f, (_e1256 == 16i)) == 0f);
} else {
phi_2421_ = (_e665 != -1i);
}
let _e1273 = phi_2421_;
if _e1273 {
let _e1277 = (_e471 + (_e537 * _e647));
let _e1278 = (_e482 + (_e548 * _e647));
let _e1279 = (_e493 + (_e559 * _e647));
let _e1283 = (_e504 + (_e570 * _e647));
let _e1284 = (_e515 + (_e581 * _e647));
let _e1285 = (_e526 + (_e592 * _e647));
let _e1294 = (((_e438 * _e1236.member_1.x) + (_e449 * _e1236.member_1.y)) + (_e460 * _e1236.member_1.z));
if ((_e1294 * _e1294) > 1e-12f) {
phi_2453_ = (1f / _e1294);
} else {
phi_2453_ = 0f;
}
let _e1299 = phi_2453_;
let _e1305 = ((((_e1277 * _e1236.member_1.x) + (_e1278 * _e1236.member_1.y)) + (_e1279 * _e1236.member_1.z)) * _e1299);
let _e1309 = (_e1277 - (_e438 * _e1305));
let _e1310 = (_e1278 - (_e449 * _e1305));
let _e1311 = (_e1279 - (_e460 * _e1305));
let _e1317 = ((((_e1283 * _e1236.member_1.x) + (_e1284 * _e1236.member_1.y)) + (_e1285 * _e1236.member_1.z)) * _e1299);
let _e1321 = (_e1283 - (_e438 * _e1317));
let _e1322 = (_e1284 - (_e449 * _e1317));
let _e1323 = (_e1285 - (_e460 * _e1317));
let _e1327 = global_1.member.member_11.member;
phi_2494_ = vec3<f32>(0f, 0f, 0f);
phi_2497_ = 1u;
loop {
let _e1331 = phi_2494_;
let _e1333 = phi_2497_;
local_22 = _e1331;
local_23 = _e1331;
local_24 = _e1331;
let _e1337 = global_1.member.member_12.member_8;
let _e1338 = (_e1333 <= _e1337);
if _e1338 {
let _e1342 = global_1.member.member_12.member_5;
phi_2517_ = 0u;
loop {
let _e1346 = phi_2517_;
local_21 = _e1346;
let _e1350 = ((1u << bitcast<u32>((_e1346 & 31u))) < _e1327);
if _e1350 {
phi_2518_ = (_e1346 + 1u);
} else {
phi_2518_ = u32();
}
let _e1353 = phi_2518_;
continue;
continuing {
phi_2517_ = _e1353;
break if !(_e1350);
}
}
phi_2530_ = 0u;
loop {
let _e1356 = phi_2530_;
local_9 = _e1356;
local_10 = _e1356;
let _e1360 = ((1u << bitcast<u32>((_e1356 & 31u))) < _e1327);
if _e1360 {
phi_2531_ = (_e1356 + 1u);
} else {
phi_2531_ = u32();
}
let _e1363 = phi_2531_;
continue;
continuing {
phi_2530_ = _e1363;
break if !(_e1360);
}
}
let _e1366 = local_9;
let _e1369 = local_10;
phi_2548_ = 0u;
loop {
let _e1372 = phi_2548_;
local_13 = _e1372;
let _e1376 = ((1u << bitcast<u32>((_e1372 & 31u))) < _e1327);
if _e1376 {
phi_2549_ = (_e1372 + 1u);
} else {
phi_2549_ = u32();
}
let _e1379 = phi_2549_;
continue;
continuing {
phi_2548_ = _e1379;
break if !(_e1376);
}
}
phi_2561_ = 0u;
loop {
let _e1382 = phi_2561_;
local_11 = _e1382;
local_12 = _e1382;
let _e1386 = ((1u << bitcast<u32>((_e1382 & 31u))) < _e1327);
if _e1386 {
phi_2562_ = (_e1382 + 1u);
} else {
phi_2562_ = u32();
}
let _e1389 = phi_2562_;
continue;
continuing {
phi_2561_ = _e1389;
break if !(_e1386);
}
}
let _e1392 = local_11;
let _e1395 = local_12;
let _e1398 = local_13;
let _e1407 = global_1.member.member_12.member_7;
phi_2587_ = 0u;
loop {
let _e1410 = phi_2587_;
local_14 = _e1410;
local_15 = _e1410;
let _e1414 = ((1u << bitcast<u32>((_e1410 & 31u))) < _e1327);
if _e1414 {
phi_2588_ = (_e1410 + 1u);
} else {
phi_2588_ = u32();
}
let _e1417 = phi_2588_;
continue;
continuing {
phi_2587_ = _e1417;
break if !(_e1414);
}
}
let _e1420 = local_14;
let _e1423 = local_15;
phi_2605_ = 0u;
loop {
let _e1426 = phi_2605_;
local_16 = _e1426;
local_17 = _e1426;
let _e1430 = ((1u << bitcast<u32>((_e1426 & 31u))) < _e1327);
if _e1430 {
phi_2606_ = (_e1426 + 1u);
} else {
phi_2606_ = u32();
}
let _e1433 = phi_2606_;
continue;
continuing {
phi_2605_ = _e1433;
break if !(_e1430);
}
}
let _e1436 = local_16;
let _e1442 = local_17;
phi_2628_ = 0u;
loop {
let _e1452 = phi_2628_;
local_20 = _e1452;
let _e1456 = ((1u << bitcast<u32>((_e1452 & 31u))) < _e1327);
if _e1456 {
phi_2629_ = (_e1452 + 1u);
} else {
phi_2629_ = u32();
}
let _e1459 = phi_2629_;
continue;
continuing {
phi_2628_ = _e1459;
break if !(_e1456);
}
}
phi_2641_ = 0u;
loop {
let _e1462 = phi_2641_;
local_18 = _e1462;
local_19 = _e1462;
let _e1466 = ((1u << bitcast<u32>((_e1462 & 31u))) < _e1327);
if _e1466 {
phi_2642_ = (_e1462 + 1u);
} else {
phi_2642_ = u32();
}
let _e1469 = phi_2642_;
continue;
continuing {
phi_2641_ = _e1469;
break if !(_e1466);
}
}
let _e1472 = local_18;
let _e1475 = local_19;
let _e1478 = local_20;
let _e1484 = (((((1u << bitcast<u32>(((2u * _e1436) & 31u))) - (1u << bitcast<u32>(((2u * (_e1442 - select(6u, _e1423, (_e1420 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1478 - select(6u, _e1475, (_e1472 < 6u)))) & 31u))));
let _e1485 = (_e1484 / 64u);
if ((_e1484 % 64u) > 0u) {
phi_2678_ = (_e1485 + 1u);
} else {
phi_2678_ = _e1485;
}
let _e1490 = phi_2678_;
let _e1493 = local_21;
local_6 = type_24(_e1493, select(6u, _e1369, (_e1366 < 6u)), (1u << bitcast<u32>(((2u * (_e1398 - select(6u, _e1395, (_e1392 < 6u)))) & 31u))), (_e1333 * _e1407), (_e1490 * 64u));
let _e1496 = local_6.member_1;
phi_2691_ = _e1331;
phi_2694_ = type_17(_e1496, 0u);
loop {
let _e1499 = phi_2691_;
let _e1501 = phi_2694_;
local_26 = _e1499;
let _e1504 = local_6.member_1;
let _e1507 = local_6.member_2;
let _e1509 = ((_e1501.member < _e1504) || (_e1501.member_1 < _e1507));
if _e1509 {
local_4.member = _e1501.member;
local_4.member_1 = _e1501.member_1;
let _e1513 = local_4.member;
let _e1514 = local_4.member_1;
let _e1516 = local_6.member;
let _e1531 = local_6.member_3;
let _e1533 = local_6.member_4;
local_5 = ((_e1531 + (18u * _e1533)) + (((((1u << bitcast<u32>(((2u * _e1516) & 31u))) - (1u << bitcast<u32>(((2u * (_e1516 - _e1513)) & 31u)))) / 3u) * 4u) + _e1514));
let _e1537 = local_5;
let _e1538 = bitcast<i32>(_e1537);
let _e1540 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1542 = select(_e1540, _e1538, (_e1538 < _e1540));
let _e1547 = global_4.member[bitcast<u32>(select(0i, _e1542, (_e1542 > 0i)))];
let _e1548 = local_5;
let _e1549 = local_6.member_4;
let _e1551 = bitcast<i32>((_e1548 + _e1549));
let _e1553 = select(_e1540, _e1551, (_e1551 < _e1540));
let _e1558 = global_4.member[bitcast<u32>(select(0i, _e1553, (_e1553 > 0i)))];
let _e1559 = local_5;
let _e1560 = local_6.member_4;
let _e1563 = bitcast<i32>((_e1559 + (2u * _e1560)));
let _e1565 = select(_e1540, _e1563, (_e1563 < _e1540));
let _e1570 = global_4.member[bitcast<u32>(select(0i, _e1565, (_e1565 > 0i)))];
let _e1571 = local_4.member;
let _e1572 = local_4.member_1;
let _e1573 = local_6.member;
let _e1587 = local_6.member_3;
let _e1588 = local_6.member_4;
local_3 = ((_e1587 + (21u * _e1588)) + (((((1u << bitcast<u32>(((2u * _e1573) & 31u))) - (1u << bitcast<u32>(((2u * (_e1573 - _e1571)) & 31u)))) / 3u) * 4u) + _e1572));
let _e1592 = local_3;
let _e1593 = bitcast<i32>(_e1592);
let _e1595 = select(_e1540, _e1593, (_e1593 < _e1540));
let _e1600 = global_4.member[bitcast<u32>(select(0i, _e1595, (_e1595 > 0i)))];
let _e1601 = local_3;
let _e1602 = local_6.member_4;
let _e1604 = bitcast<i32>((_e1601 + _e1602));
let _e1606 = select(_e1540, _e1604, (_e1604 < _e1540));
let _e1611 = global_4.member[bitcast<u32>(select(0i, _e1606, (_e1606 > 0i)))];
let _e1612 = local_3;
let _e1613 = local_6.member_4;
let _e1616 = bitcast<i32>((_e1612 + (2u * _e1613)));
let _e1618 = select(_e1540, _e1616, (_e1616 < _e1540));
let _e1623 = global_4.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1645 = ((((_e1547 <= _e1600) && ((_e1236.member.x >= (_e1547 - 0.05f)) && (_e1236.member.x <= (_e1600 + 0.05f)))) && ((_e1236.member.y >= (_e1558 - 0.05f)) && (_e1236.member.y <= (_e1611 + 0.05f)))) && ((_e1236.member.z >= (_e1570 - 0.05f)) && (_e1236.member.z <= (_e1623 + 0.05f))));
if (_e1645 && (_e1501.member > 0u)) {
phi_4525_ = _e1499;
phi_4526_ = type_17((_e1501.member - 1u), (_e1501.member_1 << bitcast<u32>(2i)));
} else {
if _e1645 {
let _e1648 = (_e1501.member_1 & 1431655765u);
let _e1652 = ((_e1648 | (_e1648 >> bitcast<u32>(1i))) & 858993459u);
let _e1656 = ((_e1652 | (_e1652 >> bitcast<u32>(2i))) & 252645135u);
let _e1660 = ((_e1656 | (_e1656 >> bitcast<u32>(4i))) & 16711935u);
let _e1667 = ((_e1501.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1671 = ((_e1667 | (_e1667 >> bitcast<u32>(1i))) & 858993459u);
let _e1675 = ((_e1671 | (_e1671 >> bitcast<u32>(2i))) & 252645135u);
let _e1679 = ((_e1675 | (_e1675 >> bitcast<u32>(4i))) & 16711935u);
local = bitcast<i32>((_e1333 * _e1342));
local_1 = bitcast<i32>(((((_e1679 | (_e1679 >> bitcast<u32>(8i))) & 65535u) * _e1327) + ((_e1660 | (_e1660 >> bitcast<u32>(8i))) & 65535u)));
local_2 = bitcast<i32>((_e1327 * _e1327));
let _e1687 = local;
let _e1688 = local_1;
let _e1689 = (_e1687 + _e1688);
let _e1691 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1693 = select(_e1691, _e1689, (_e1689 < _e1691));
let _e1698 = global_3.member[bitcast<u32>(select(0i, _e1693, (_e1693 > 0i)))];
let _e1699 = local;
let _e1700 = local_2;
let _e1702 = local_1;
let _e1703 = ((_e1699 + _e1700) + _e1702);
let _e1705 = select(_e1691, _e1703, (_e1703 < _e1691));
let _e1710 = global_3.member[bitcast<u32>(select(0i, _e1705, (_e1705 > 0i)))];
let _e1711 = local;
let _e1712 = local_2;
let _e1715 = local_1;
let _e1716 = ((_e1711 + (2i * _e1712)) + _e1715);
let _e1718 = select(_e1691, _e1716, (_e1716 < _e1691));
let _e1723 = global_3.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1724 = local;
let _e1725 = local_2;
let _e1728 = local_1;
let _e1729 = ((_e1724 + (3i * _e1725)) + _e1728);
let _e1731 = select(_e1691, _e1729, (_e1729 < _e1691));
let _e1736 = global_3.member[bitcast<u32>(select(0i, _e1731, (_e1731 > 0i)))];
let _e1737 = local;
let _e1738 = local_2;
let _e1741 = local_1;
let _e1742 = ((_e1737 + (4i * _e1738)) + _e1741);
let _e1744 = select(_e1691, _e1742, (_e1742 < _e1691));
let _e1749 = global_3.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1750 = local;
let _e1751 = local_2;
let _e1754 = local_1;
let _e1755 = ((_e1750 + (5i * _e1751)) + _e1754);
let _e1757 = select(_e1691, _e1755, (_e1755 < _e1691));
let _e1762 = global_3.member[bitcast<u32>(select(0i, _e1757, (_e1757 > 0i)))];
let _e1763 = local;
let _e1764 = local_2;
let _e1767 = local_1;
let _e1768 = ((_e1763 + (6i * _e1764)) + _e1767);
let _e1770 = select(_e1691, _e1768, (_e1768 < _e1691));
let _e1775 = global_3.member[bitcast<u32>(select(0i, _e1770, (_e1770 > 0i)))];
let _e1776 = local;
let _e1777 = local_2;
let _e1780 = local_1;
let _e1781 = ((_e1776 + (7i * _e1777)) + _e1780);
let _e1783 = select(_e1691, _e1781, (_e1781 < _e1691));
let _e1788 = global_3.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1789 = local;
let _e1790 = local_2;
let _e1793 = local_1;
let _e1794 = ((_e1789 + (8i * _e1790)) + _e1793);
let _e1796 = select(_e1691, _e1794, (_e1794 < _e1691));
let _e1801 = global_3.member[bitcast<u32>(select(0i, _e1796, (_e1796 > 0i)))];
let _e1802 = local;
let _e1803 = local_2;
let _e1806 = local_1;
let _e1807 = ((_e1802 + (9i * _e1803)) + _e1806);
let _e1809 = select(_e1691, _e1807, (_e1807 < _e1691));
let _e1814 = global_3.member[bitcast<u32>(select(0i, _e1809, (_e1809 > 0i)))];
let _e1815 = local;
let _e1816 = local_2;
let _e1819 = local_1;
let _e1820 = ((_e1815 + (10i * _e1816)) + _e1819);
let _e1822 = select(_e1691, _e1820, (_e1820 < _e1691));
let _e1827 = global_3.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1828 = local;
let _e1829 = local_2;
let _e1832 = local_1;
let _e1833 = ((_e1828 + (11i * _e1829)) + _e1832);
let _e1835 = select(_e1691, _e1833, (_e1833 < _e1691));
let _e1840 = global_3.member[bitcast<u32>(select(0i, _e1835, (_e1835 > 0i)))];
let _e1841 = local;
let _e1842 = local_2;
let _e1845 = local_1;
let _e1846 = ((_e1841 + (12i * _e1842)) + _e1845);
let _e1848 = select(_e1691, _e1846, (_e1846 < _e1691));
let _e1853 = global_3.member[bitcast<u32>(select(0i, _e1848, (_e1848 > 0i)))];
let _e1854 = local;
let _e1855 = local_2;
let _e1858 = local_1;
let _e1859 = ((_e1854 + (13i * _e1855)) + _e1858);
let _e1861 = select(_e1691, _e1859, (_e1859 < _e1691));
let _e1866 = global_3.member[bitcast<u32>(select(0i, _e1861, (_e1861 > 0i)))];
let _e1867 = local;
let _e1868 = local_2;
let _e1871 = local_1;
let _e1872 = ((_e1867 + (14i * _e1868)) + _e1871);
let _e1874 = select(_e1691, _e1872, (_e1872 < _e1691));
let _e1879 = global_3.member[bitcast<u32>(select(0i, _e1874, (_e1874 > 0i)))];
let _e1880 = local;
let _e1881 = local_2;
let _e1884 = local_1;
let _e1885 = ((_e1880 + (15i * _e1881)) + _e1884);
let _e1887 = select(_e1691, _e1885, (_e1885 < _e1691));
let _e1892 = global_3.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1893 = local;
let _e1894 = local_2;
let _e1897 = local_1;
let _e1898 = ((_e1893 + (16i * _e1894)) + _e1897);
let _e1900 = select(_e1691, _e1898, (_e1898 < _e1691));
let _e1905 = global_3.member[bitcast<u32>(select(0i, _e1900, (_e1900 > 0i)))];
let _e1906 = local;
let _e1907 = local_2;
let _e1910 = local_1;
let _e1911 = ((_e1906 + (17i * _e1907)) + _e1910);
let _e1913 = select(_e1691, _e1911, (_e1911 < _e1691));
let _e1918 = global_3.member[bitcast<u32>(select(0i, _e1913, (_e1913 > 0i)))];
let _e1919 = local;
let _e1920 = local_2;
let _e1923 = local_1;
let _e1924 = ((_e1919 + (18i * _e1920)) + _e1923);
let _e1926 = select(_e1691, _e1924, (_e1924 < _e1691));
let _e1931 = global_3.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1932 = local;
let _e1933 = local_2;
let _e1936 = local_1;
let _e1937 = ((_e1932 + (19i * _e1933)) + _e1936);
let _e1939 = select(_e1691, _e1937, (_e1937 < _e1691));
let _e1944 = global_3.member[bitcast<u32>(select(0i, _e1939, (_e1939 > 0i)))];
let _e1945 = local;
let _e1946 = local_2;
let _e1949 = local_1;
let _e1950 = ((_e1945 + (20i * _e1946)) + _e1949);
let _e1952 = select(_e1691, _e1950, (_e1950 < _e1691));
let _e1957 = global_3.member[bitcast<u32>(select(0i, _e1952, (_e1952 > 0i)))];
let _e1958 = local;
let _e1959 = local_2;
let _e1962 = local_1;
let _e1963 = ((_e1958 + (23i * _e1959)) + _e1962);
let _e1965 = select(_e1691, _e1963, (_e1963 < _e1691));
let _e1970 = global_3.member[bitcast<u32>(select(0i, _e1965, (_e1965 > 0i)))];
let _e1971 = local;
let _e1972 = local_2;
let _e1975 = local_1;
let _e1976 = ((_e1971 + (24i * _e1972)) + _e1975);
let _e1978 = select(_e1691, _e1976, (_e1976 < _e1691));
let _e1983 = global_3.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1988 = (((_e1236.member_1.x * _e1736) + (_e1236.member_1.y * _e1749)) + (_e1236.member_1.z * _e1762));
let _e1991 = bitcast<f32>((bitcast<u32>(_e1988) & 2147483647u));
if (_e1991 < 1e-6f) {
phi_4478_ = vec3<f32>();
phi_4479_ = true;
} else {
let _e1993 = (1f / _e1988);
let _e2002 = ((((_e1236.member_1.x * (_e1236.member.x - _e1698)) + (_e1236.member_1.y * (_e1236.member.y - _e1710))) + (_e1236.member_1.z * (_e1236.member.z - _e1723))) * _e1993);
let _e2006 = (_e1775 + (_e1853 * _e2002));
let _e2007 = (_e1788 + (_e1866 * _e2002));
let _e2008 = (_e1801 + (_e1879 * _e2002));
let _e2014 = ((((_e1236.member_1.x * _e2006) + (_e1236.member_1.y * _e2007)) + (_e1236.member_1.z * _e2008)) * _e1993);
let _e2018 = (_e2006 - (_e1736 * _e2014));
let _e2019 = (_e2007 - (_e1749 * _e2014));
let _e2020 = (_e2008 - (_e1762 * _e2014));
let _e2024 = (_e1814 + (_e1892 * _e2002));
let _e2025 = (_e1827 + (_e1905 * _e2002));
let _e2026 = (_e1840 + (_e1918 * _e2002));
let _e2032 = ((((_e1236.member_1.x * _e2024) + (_e1236.member_1.y * _e2025)) + (_e1236.member_1.z * _e2026)) * _e1993);
let _e2036 = (_e2024 - (_e1736 * _e2032));
let _e2037 = (_e2025 - (_e1749 * _e2032));
let _e2038 = (_e2026 - (_e1762 * _e2032));
if ((_e2002 < -(0.05f)) || (bitcast<f32>((bitcast<u32>((_e2002 - _e1983)) & 2147483647u)) > ((0.5f * (bitcast<f32>((bitcast<u32>((((_e2018 * _e1736) + (_e2019 * _e1749)) + (_e2020 * _e1762))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2036 * _e1736) + (_e2037 * _e1749)) + (_e2038 * _e1762))) & 2147483647u)))) + 0.05f))) {
phi_4473_ = vec3<f32>();
phi_4474_ = true;
} else {
let _e2079 = (((((_e2019 * _e2038) - (_e2020 * _e2037)) * _e1236.member_1.x) + (((_e2020 * _e2036) - (_e2018 * _e2038)) * _e1236.member_1.y)) + (((_e2018 * _e2037) - (_e2019 * _e2036)) * _e1236.member_1.z));
let _e2082 = bitcast<f32>((bitcast<u32>(_e2079) & 2147483647u));
if (_e2082 < 1e-12f) {
phi_4468_ = vec3<f32>();
phi_4469_ = true;
} else {
let _e2090 = (_e1236.member.x - (_e1698 + (_e1736 * _e2002)));
let _e2091 = (_e1236.member.y - (_e1710 + (_e1749 * _e2002)));
let _e2092 = (_e1236.member.z - (_e1723 + (_e1762 * _e2002)));
let _e2107 = ((((((_e2091 * _e2038) - (_e2092 * _e2037)) * _e1236.member_1.x) + (((_e2092 * _e2036) - (_e2090 * _e2038)) * _e1236.member_1.y)) + (((_e2090 * _e2037) - (_e2091 * _e2036)) * _e1236.member_1.z)) / _e2079);
let _e2122 = ((((((_e2019 * _e2092) - (_e2020 * _e2091)) * _e1236.member_1.x) + (((_e2020 * _e2090) - (_e2018 * _e2092)) * _e1236.member_1.y)) + (((_e2018 * _e2091) - (_e2019 * _e2090)) * _e1236.member_1.z)) / _e2079);
let _e2185 = bitcast<f32>((bitcast<u32>(((((((_e1310 * _e2038) - (_e1311 * _e2037)) * _e1236.member_1.x) + (((_e1311 * _e2036) - (_e1309 * _e2038)) * _e1236.member_1.y)) + (((_e1309 * _e2037) - (_e1310 * _e2036)) * _e1236.member_1.z)) / _e2079)) & 2147483647u));
let _e2188 = bitcast<f32>((bitcast<u32>(((((((_e1322 * _e2038) - (_e1323 * _e2037)) * _e1236.member_1.x) + (((_e1323 * _e2036) - (_e1321 * _e2038)) * _e1236.member_1.y)) + (((_e1321 * _e2037) - (_e1322 * _e2036)) * _e1236.member_1.z)) / _e2079)) & 2147483647u));
let _e2190 = select(_e2188, _e2185, (_e2185 > _e2188));
let _e2192 = select(1e-3f, _e2190, (_e2190 > 1e-3f));
let _e2195 = bitcast<f32>((bitcast<u32>(((((((_e2019 * _e1311) - (_e2020 * _e1310)) * _e1236.member_1.x) + (((_e2020 * _e1309) - (_e2018 * _e1311)) * _e1236.member_1.y)) + (((_e2018 * _e1310) - (_e2019 * _e1309)) * _e1236.member_1.z)) / _e2079)) & 2147483647u));
let _e2198 = bitcast<f32>((bitcast<u32>(((((((_e2019 * _e1323) - (_e2020 * _e1322)) * _e1236.member_1.x) + (((_e2020 * _e1321) - (_e2018 * _e1323)) * _e1236.member_1.y)) + (((_e2018 * _e1322) - (_e2019 * _e1321)) * _e1236.member_1.z)) / _e2079)) & 2147483647u));
let _e2200 = select(_e2198, _e2195, (_e2195 > _e2198));
let _e2202 = select(1e-3f, _e2200, (_e2200 > 1e-3f));
let _e2215 = ((bitcast<f32>((bitcast<u32>(_e2107) & 2147483647u)) > (0.5f * (1f + _e2192))) || (bitcast<f32>((bitcast<u32>(_e2122) & 2147483647u)) > (0.5f * (1f + _e2202))));
if _e2215 {
phi_4467_ = vec3<f32>();
} else {
let _e2216 = (1e-4f * _e2192);
let _e2218 = select(_e2216, 1f, (1f > _e2216));
let _e2220 = select(_e2216, 1e-4f, (1e-4f > _e2216));
let _e2222 = (0.5f * (_e2218 + _e2220));
let _e2223 = (0.5f / _e2220);
let _e2224 = (1f / _e2218);
let _e2226 = (0.5f * _e2192);
let _e2227 = (_e2107 + _e2226);
let _e2228 = -(_e2227);
let _e2231 = (_e2222 - select(_e2228, _e2227, (_e2227 > _e2228)));
let _e2233 = select(0f, _e2231, (_e2231 > 0f));
let _e2235 = select(_e2220, _e2233, (_e2233 < _e2220));
let _e2238 = (_e2231 - _e2220);
let _e2242 = (((_e2235 * (_e2235 * _e2223)) + select(0f, _e2238, (_e2238 > 0f))) * _e2224);
let _e2246 = (_e2107 - _e2226);
let _e2247 = -(_e2246);
let _e2250 = (_e2222 - select(_e2247, _e2246, (_e2246 > _e2247)));
let _e2252 = select(0f, _e2250, (_e2250 > 0f));
let _e2254 = select(_e2220, _e2252, (_e2252 < _e2220));
let _e2257 = (_e2250 - _e2220);
let _e2261 = (((_e2254 * (_e2254 * _e2223)) + select(0f, _e2257, (_e2257 > 0f))) * _e2224);
let _e2267 = (1e-4f * _e2202);
let _e2269 = select(_e2267, 1f, (1f > _e2267));
let _e2271 = select(_e2267, 1e-4f, (1e-4f > _e2267));
let _e2273 = (0.5f * (_e2269 + _e2271));
let _e2274 = (0.5f / _e2271);
let _e2275 = (1f / _e2269);
let _e2277 = (0.5f * _e2202);
let _e2278 = (_e2122 + _e2277);
let _e2279 = -(_e2278);
let _e2282 = (_e2273 - select(_e2279, _e2278, (_e2278 > _e2279)));
let _e2284 = select(0f, _e2282, (_e2282 > 0f));
let _e2286 = select(_e2271, _e2284, (_e2284 < _e2271));
let _e2289 = (_e2282 - _e2271);
let _e2293 = (((_e2286 * (_e2286 * _e2274)) + select(0f, _e2289, (_e2289 > 0f))) * _e2275);
let _e2297 = (_e2122 - _e2277);
let _e2298 = -(_e2297);
let _e2301 = (_e2273 - select(_e2298, _e2297, (_e2297 > _e2298)));
let _e2303 = select(0f, _e2301, (_e2301 > 0f));
let _e2305 = select(_e2271, _e2303, (_e2303 < _e2271));
let _e2308 = (_e2301 - _e2271);
let _e2312 = (((_e2305 * (_e2305 * _e2274)) + select(0f, _e2308, (_e2308 > 0f))) * _e2275);
let _e2321 = select(_e1970, _e2002, (_e2002 < _e1970));
let _e2334 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1236.member_2.x * _e1736) + (_e1236.member_2.y * _e1749)) + (_e1236.member_2.z * _e1762))) & 2147483647u)));
let _e2341 = (((_e1236.member_1.x * _e438) + (_e1236.member_1.y * _e449)) + (_e1236.member_1.z * _e460));
let _e2343 = select(1f, -1f, (_e2341 > 0f));
let _e2351 = select(_e2343, -(_e2343), ((((_e1236.member_2.x * _e1236.member_1.x) + (_e1236.member_2.y * _e1236.member_1.y)) + (_e1236.member_2.z * _e1236.member_1.z)) < 0f));
let _e2352 = (_e1236.member_2.x * _e2351);
let _e2353 = (_e1236.member_2.y * _e2351);
let _e2354 = (_e1236.member_2.z * _e2351);
let _e2363 = ((((_e2352 * _e438) + (_e2353 * _e449)) + (_e2354 * _e460)) > 0f);
let _e2372 = -((((select(_e2352, (_e1236.member_1.x * _e2343), _e2363) * _e1736) + (select(_e2353, (_e1236.member_1.y * _e2343), _e2363) * _e1749)) + (select(_e2354, (_e1236.member_1.z * _e2343), _e2363) * _e1762)));
let _e2377 = -(_e2372);
let _e2387 = global_1.member.member_13.member;
let _e2392 = -((_e2387.member * _e2321));
let _e2394 = select(-87f, _e2392, (_e2392 > -87f));
let _e2396 = select(88f, _e2394, (_e2394 < 88f));
let _e2398 = ((_e2396 * 1.442695f) + 0.5f);
let _e2400 = select(-127f, _e2398, (_e2398 > -127f));
let _e2402 = select(128f, _e2400, (_e2400 < 128f));
let _e2409 = select(0i, select(select(i32(_e2402), i32(-2147483648), (_e2402 < -2147483600f)), 2147483647i, (_e2402 > 2147483500f)), (_e2402 == _e2402));
let _e2413 = (_e2409 - select(0i, 1i, (_e2402 < f32(_e2409))));
let _e2414 = f32(_e2413);
let _e2418 = ((_e2396 - (_e2414 * 0.6933594f)) - (_e2414 * -2.1219444e-4f));
let _e2440 = -((_e2387.member_1 * _e2321));
let _e2442 = select(-87f, _e2440, (_e2440 > -87f));
let _e2444 = select(88f, _e2442, (_e2442 < 88f));
let _e2446 = ((_e2444 * 1.442695f) + 0.5f);
let _e2448 = select(-127f, _e2446, (_e2446 > -127f));
let _e2450 = select(128f, _e2448, (_e2448 < 128f));
let _e2457 = select(0i, select(select(i32(_e2450), i32(-2147483648), (_e2450 < -2147483600f)), 2147483647i, (_e2450 > 2147483500f)), (_e2450 == _e2450));
let _e2461 = (_e2457 - select(0i, 1i, (_e2450 < f32(_e2457))));
let _e2462 = f32(_e2461);
let _e2466 = ((_e2444 - (_e2462 * 0.6933594f)) - (_e2462 * -2.1219444e-4f));
let _e2488 = -((_e2387.member_2 * _e2321));
let _e2490 = select(-87f, _e2488, (_e2488 > -87f));
let _e2492 = select(88f, _e2490, (_e2490 < 88f));
let _e2494 = ((_e2492 * 1.442695f) + 0.5f);
let _e2496 = select(-127f, _e2494, (_e2494 > -127f));
let _e2498 = select(128f, _e2496, (_e2496 < 128f));
let _e2505 = select(0i, select(select(i32(_e2498), i32(-2147483648), (_e2498 < -2147483600f)), 2147483647i, (_e2498 > 2147483500f)), (_e2498 == _e2498));
let _e2509 = (_e2505 - select(0i, 1i, (_e2498 < f32(_e2505))));
let _e2510 = f32(_e2509);
let _e2514 = ((_e2492 - (_e2510 * 0.6933594f)) - (_e2510 * -2.1219444e-4f));
let _e2540 = ((((((select(_e2242, (1f - _e2242), (_e2227 >= 0f)) - select(_e2261, (1f - _e2261), (_e2246 >= 0f))) * (1f / _e2192)) * ((select(_e2293, (1f - _e2293), (_e2278 >= 0f)) - select(_e2312, (1f - _e2312), (_e2297 >= 0f))) * (1f / _e2202))) / _e2082) * (select((select(0f, _e2377, (_e2377 > 0f)) * _e1236.member_4), select(0f, _e2372, (_e2372 > 0f)), ((_e1988 * _e2341) > 0f)) / select(_e2334, _e1991, (_e1991 > _e2334)))) * (1f / 3.1415927f));
phi_4467_ = vec3<f32>(((_e1931 * ((1f + (_e2418 * (1f + (_e2418 * (0.5f + (_e2418 * (0.16666667f + (_e2418 * (0.041666668f + (_e2418 * (0.008333334f + (_e2418 * (0.001388889f + (_e2418 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2413 + 127i)) << bitcast<u32>(23i))))) * _e2540), ((_e1944 * ((1f + (_e2466 * (1f + (_e2466 * (0.5f + (_e2466 * (0.16666667f + (_e2466 * (0.041666668f + (_e2466 * (0.008333334f + (_e2466 * (0.001388889f + (_e2466 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2461 + 127i)) << bitcast<u32>(23i))))) * _e2540), ((_e1957 * ((1f + (_e2514 * (1f + (_e2514 * (0.5f + (_e2514 * (0.16666667f + (_e2514 * (0.041666668f + (_e2514 * (0.008333334f + (_e2514 * (0.001388889f + (_e2514 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2509 + 127i)) << bitcast<u32>(23i))))) * _e2540));
}
let _e2546 = phi_4467_;
phi_4468_ = _e2546;
phi_4469_ = _e2215;
}
let _e2548 = phi_4468_;
let _e2550 = phi_4469_;
phi_4473_ = _e2548;
phi_4474_ = _e2550;
}
let _e2552 = phi_4473_;
let _e2554 = phi_4474_;
phi_4478_ = _e2552;
phi_4479_ = _e2554;
}
let _e2556 = phi_4478_;
let _e2558 = phi_4479_;
phi_4495_ = (_e1499 + select(_e2556, vec3<f32>(0f, 0f, 0f), vec3(_e2558)));
} else {
phi_4495_ = _e1499;
}
let _e2563 = phi_4495_;
let _e2564 = local_6.member_1;
phi_4503_ = type_17(_e1501.member, (_e1501.member_1 + 1u));
loop {
let _e2568 = phi_4503_;
local_25 = _e2568;
let _e2574 = (((_e2568.member_1 & 3u) == 0u) && (_e2568.member < _e2564));
if _e2574 {
phi_4504_ = type_17((_e2568.member + 1u), (_e2568.member_1 >> bitcast<u32>(2i)));
} else {
phi_4504_ = type_17();
}
let _e2580 = phi_4504_;
continue;
continuing {
phi_4503_ = _e2580;
break if !(_e2574);
}
}
phi_4525_ = _e2563;
let _e2962 = local_25;
phi_4526_ = _e2962;
}
let _e2587 = phi_4525_;
let _e2589 = phi_4526_;
phi_2692_ = _e2587;
phi_2695_ = _e2589;
} else {
phi_2692_ = vec3<f32>();
phi_2695_ = type_17();
}
let _e2591 = phi_2692_;
let _e2593 = phi_2695_;
continue;
continuing {
phi_2691_ = _e2591;
phi_2694_ = _e2593;
break if !(_e1509);
}
}
let _e2967 = local_26;
phi_2495_ = _e2967;
phi_2498_ = (_e1333 + 1u);
} else {
phi_2495_ = vec3<f32>();
phi_2498_ = u32();
}
let _e2597 = phi_2495_;
let _e2599 = phi_2498_;
continue;
continuing {
phi_2494_ = _e2597;
phi_2497_ = _e2599;
break if !(_e1338);
}
}
let _e2608 = (1f / select(_e438, select(1e-12f, -1e-12f, (_e438 < 0f)), (bitcast<f32>((bitcast<u32>(_e438) & 2147483647u)) < 1e-12f)));
let _e2616 = (1f / select(_e449, select(1e-12f, -1e-12f, (_e449 < 0f)), (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) < 1e-12f)));
let _e2624 = (1f / select(_e460, select(1e-12f, -1e-12f, (_e460 < 0f)), (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) < 1e-12f)));
let _e2628 = global_1.member.member_13.member_4;
let _e2635 = global_1.member.member_13.member_5;
let _e2640 = ((_e2628.member - _e755) * _e2608);
let _e2642 = ((_e2635.member - _e755) * _e2608);
let _e2644 = ((_e2628.member_1 - _e756) * _e2616);
let _e2646 = ((_e2635.member_1 - _e756) * _e2616);
let _e2648 = ((_e2628.member_2 - _e757) * _e2624);
let _e2650 = ((_e2635.member_2 - _e757) * _e2624);
let _e2652 = select(_e2642, _e2640, (_e2640 < _e2642));
let _e2654 = select(_e2646, _e2644, (_e2644 < _e2646));
let _e2656 = select(_e2654, _e2652, (_e2652 > _e2654));
let _e2658 = select(_e2650, _e2648, (_e2648 < _e2650));
let _e2660 = select(_e2658, _e2656, (_e2656 > _e2658));
let _e2662 = select(_e2642, _e2640, (_e2640 > _e2642));
let _e2664 = select(_e2646, _e2644, (_e2644 > _e2646));
let _e2666 = select(_e2664, _e2662, (_e2662 < _e2664));
let _e2668 = select(_e2650, _e2648, (_e2648 > _e2650));
let _e2670 = select(_e2668, _e2666, (_e2666 < _e2668));
let _e2672 = select(0f, _e2660, (_e2660 > 0f));
let _e2674 = select(_e758, _e2670, (_e2670 < _e758));
let _e2675 = (_e2674 > _e2672);
let _e2678 = (select(0f, _e2674, _e2675) - select(0f, _e2672, _e2675));
let _e2682 = global_1.member.member_13.member;
let _e2687 = -((_e2682.member * _e2678));
let _e2689 = select(-87f, _e2687, (_e2687 > -87f));
let _e2691 = select(88f, _e2689, (_e2689 < 88f));
let _e2693 = ((_e2691 * 1.442695f) + 0.5f);
let _e2695 = select(-127f, _e2693, (_e2693 > -127f));
let _e2697 = select(128f, _e2695, (_e2695 < 128f));
let _e2704 = select(0i, select(select(i32(_e2697), i32(-2147483648), (_e2697 < -2147483600f)), 2147483647i, (_e2697 > 2147483500f)), (_e2697 == _e2697));
let _e2708 = (_e2704 - select(0i, 1i, (_e2697 < f32(_e2704))));
let _e2709 = f32(_e2708);
let _e2713 = ((_e2691 - (_e2709 * 0.6933594f)) - (_e2709 * -2.1219444e-4f));
let _e2735 = -((_e2682.member_1 * _e2678));
let _e2737 = select(-87f, _e2735, (_e2735 > -87f));
let _e2739 = select(88f, _e2737, (_e2737 < 88f));
let _e2741 = ((_e2739 * 1.442695f) + 0.5f);
let _e2743 = select(-127f, _e2741, (_e2741 > -127f));
let _e2745 = select(128f, _e2743, (_e2743 < 128f));
let _e2752 = select(0i, select(select(i32(_e2745), i32(-2147483648), (_e2745 < -2147483600f)), 2147483647i, (_e2745 > 2147483500f)), (_e2745 == _e2745));
let _e2756 = (_e2752 - select(0i, 1i, (_e2745 < f32(_e2752))));
let _e2757 = f32(_e2756);
let _e2761 = ((_e2739 - (_e2757 * 0.6933594f)) - (_e2757 * -2.1219444e-4f));
let _e2783 = -((_e2682.member_2 * _e2678));
let _e2785 = select(-87f, _e2783, (_e2783 > -87f));
let _e2787 = select(88f, _e2785, (_e2785 < 88f));
let _e2789 = ((_e2787 * 1.442695f) + 0.5f);
let _e2791 = select(-127f, _e2789, (_e2789 > -127f));
let _e2793 = select(128f, _e2791, (_e2791 < 128f));
let _e2800 = select(0i, select(select(i32(_e2793), i32(-2147483648), (_e2793 < -2147483600f)), 2147483647i, (_e2793 > 2147483500f)), (_e2793 == _e2793));
let _e2804 = (_e2800 - select(0i, 1i, (_e2793 < f32(_e2800))));
let _e2805 = f32(_e2804);
let _e2809 = ((_e2787 - (_e2805 * 0.6933594f)) - (_e2805 * -2.1219444e-4f));
let _e2832 = local_22;
let _e2837 = local_23;
let _e2842 = local_24;
phi_4898_ = array<f32, 18>(_e156, _e166, (_e177 + (((_e2832.x * _e1236.member_3.x) * ((1f + (_e2713 * (1f + (_e2713 * (0.5f + (_e2713 * (0.16666667f + (_e2713 * (0.041666668f + (_e2713 * (0.008333334f + (_e2713 * (0.001388889f + (_e2713 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2708 + 127i)) << bitcast<u32>(23i))))) * select(_e603, 1f, _e673))), (_e188 + (((_e2837.y * _e1236.member_3.y) * ((1f + (_e2761 * (1f + (_e2761 * (0.5f + (_e2761 * (0.16666667f + (_e2761 * (0.041666668f + (_e2761 * (0.008333334f + (_e2761 * (0.001388889f + (_e2761 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2756 + 127i)) << bitcast<u32>(23i))))) * select(_e614, 1f, _e673))), (_e199 + (((_e2842.z * _e1236.member_3.z) * ((1f + (_e2809 * (1f + (_e2809 * (0.5f + (_e2809 * (0.16666667f + (_e2809 * (0.041666668f + (_e2809 * (0.008333334f + (_e2809 * (0.001388889f + (_e2809 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2804 + 127i)) << bitcast<u32>(23i))))) * select(_e625, 1f, _e673))), _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342);
} else {
phi_4898_ = array<f32, 18>(_e156, _e166, _e177, _e188, _e199, _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342);
}
let _e2857 = phi_4898_;
global_5.member[_e145] = _e2857[0];
global_5.member[_e157] = _e2857[1];
global_5.member[_e168] = _e2857[2];
global_5.member[_e179] = _e2857[3];
global_5.member[_e190] = _e2857[4];
global_5.member[_e201] = _e2857[5];
global_5.member[_e212] = _e2857[6];
global_5.member[_e223] = _e2857[7];
global_5.member[_e234] = _e2857[8];
global_5.member[_e245] = _e2857[9];
global_5.member[_e256] = _e2857[10];
global_5.member[_e267] = _e2857[11];
global_5.member[_e278] = _e2857[12];
global_5.member[_e289] = _e2857[13];
global_5.member[_e300] = _e2857[14];
global_5.member[_e311] = _e2857[15];
global_5.member[_e322] = _e2857[16];
global_5.member[_e333] = _e2857[17];
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
