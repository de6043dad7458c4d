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
var local_9: u32;
var local_10: u32;
var phi_2535_: u32;
var phi_2536_: u32;
var phi_2548_: u32;
var phi_2549_: u32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var phi_2574_: u32;
var phi_2575_: u32;
var local_14: u32;
var local_15: u32;
var phi_2592_: u32;
var phi_2593_: u32;
var local_16: u32;
var local_17: u32;
var phi_2615_: u32;
var phi_2616_: u32;
var phi_2628_: u32;
var phi_2629_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_2665_: u32;
var phi_2678_: vec3<f32>;
var phi_2681_: type_17;
var phi_2716_: u32;
var phi_2717_: u32;
var local_21: u32;
var local_22: u32;
var phi_2829_: u32;
var phi_2830_: u32;
var local_23: u32;
var local_24: u32;
var phi_4486_: vec3<f32>;
var phi_4487_: vec3<f32>;
var phi_4488_: bool;
var phi_4492_: vec3<f32>;
var phi_4493_: bool;
var phi_4497_: vec3<f32>;
var phi_4498_: bool;
var phi_4514_: vec3<f32>;
var phi_4522_: type_17;
var phi_4523_: type_17;
var phi_4544_: vec3<f32>;
var phi_4545_: type_17;
var phi_2679_: vec3<f32>;
var phi_2682_: type_17;
var phi_2495_: vec3<f32>;
var phi_2498_: u32;
var local_25: vec3<f32>;
var local_26: vec3<f32>;
var local_27: vec3<f32>;
var phi_4913_: array<f32, 18>;
var local_28: type_17;
var local_29: vec3<f32>;
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
local_25 = _e1331;
local_26 = _e1331;
local_27 = _e1331;
let _e1337 = global_1.member.member_12.member_7;
let _e1338 = (_e1333 <= _e1337);
if _e1338 {
let _e1342 = global_1.member.member_12.member_5;
phi_2517_ = 0u;
loop {
let _e1346 = phi_2517_;
local_9 = _e1346;
local_10 = _e1346;
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
let _e1356 = local_9;
let _e1359 = local_10;
phi_2535_ = 0u;
loop {
let _e1362 = phi_2535_;
local_13 = _e1362;
let _e1366 = ((1u << bitcast<u32>((_e1362 & 31u))) < _e1327);
if _e1366 {
phi_2536_ = (_e1362 + 1u);
} else {
phi_2536_ = u32();
}
let _e1369 = phi_2536_;
continue;
continuing {
phi_2535_ = _e1369;
break if !(_e1366);
}
}
phi_2548_ = 0u;
loop {
let _e1372 = phi_2548_;
local_11 = _e1372;
local_12 = _e1372;
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
let _e1382 = local_11;
let _e1385 = local_12;
let _e1388 = local_13;
let _e1397 = global_1.member.member_12.member_6;
phi_2574_ = 0u;
loop {
let _e1400 = phi_2574_;
local_14 = _e1400;
local_15 = _e1400;
let _e1404 = ((1u << bitcast<u32>((_e1400 & 31u))) < _e1327);
if _e1404 {
phi_2575_ = (_e1400 + 1u);
} else {
phi_2575_ = u32();
}
let _e1407 = phi_2575_;
continue;
continuing {
phi_2574_ = _e1407;
break if !(_e1404);
}
}
let _e1410 = local_14;
let _e1413 = local_15;
phi_2592_ = 0u;
loop {
let _e1416 = phi_2592_;
local_16 = _e1416;
local_17 = _e1416;
let _e1420 = ((1u << bitcast<u32>((_e1416 & 31u))) < _e1327);
if _e1420 {
phi_2593_ = (_e1416 + 1u);
} else {
phi_2593_ = u32();
}
let _e1423 = phi_2593_;
continue;
continuing {
phi_2592_ = _e1423;
break if !(_e1420);
}
}
let _e1426 = local_16;
let _e1432 = local_17;
phi_2615_ = 0u;
loop {
let _e1442 = phi_2615_;
local_20 = _e1442;
let _e1446 = ((1u << bitcast<u32>((_e1442 & 31u))) < _e1327);
if _e1446 {
phi_2616_ = (_e1442 + 1u);
} else {
phi_2616_ = u32();
}
let _e1449 = phi_2616_;
continue;
continuing {
phi_2615_ = _e1449;
break if !(_e1446);
}
}
phi_2628_ = 0u;
loop {
let _e1452 = phi_2628_;
local_18 = _e1452;
local_19 = _e1452;
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
let _e1462 = local_18;
let _e1465 = local_19;
let _e1468 = local_20;
let _e1474 = (((((1u << bitcast<u32>(((2u * _e1426) & 31u))) - (1u << bitcast<u32>(((2u * (_e1432 - select(6u, _e1413, (_e1410 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1468 - select(6u, _e1465, (_e1462 < 6u)))) & 31u))));
let _e1475 = (_e1474 / 64u);
if ((_e1474 % 64u) > 0u) {
phi_2665_ = (_e1475 + 1u);
} else {
phi_2665_ = _e1475;
}
let _e1480 = phi_2665_;
local_6 = type_24(_e1327, select(6u, _e1359, (_e1356 < 6u)), (1u << bitcast<u32>(((2u * (_e1388 - select(6u, _e1385, (_e1382 < 6u)))) & 31u))), (_e1333 * _e1397), (_e1480 * 64u));
let _e1484 = local_6.member_1;
phi_2678_ = _e1331;
phi_2681_ = type_17(_e1484, 0u);
loop {
let _e1487 = phi_2678_;
let _e1489 = phi_2681_;
local_29 = _e1487;
let _e1492 = local_6.member_1;
let _e1495 = local_6.member_2;
let _e1497 = ((_e1489.member < _e1492) || (_e1489.member_1 < _e1495));
if _e1497 {
local_4.member = _e1489.member;
local_4.member_1 = _e1489.member_1;
let _e1501 = local_4.member;
let _e1502 = local_4.member_1;
let _e1504 = local_6.member;
phi_2716_ = 0u;
loop {
let _e1506 = phi_2716_;
local_21 = _e1506;
local_22 = _e1506;
let _e1510 = ((1u << bitcast<u32>((_e1506 & 31u))) < _e1504);
if _e1510 {
phi_2717_ = (_e1506 + 1u);
} else {
phi_2717_ = u32();
}
let _e1513 = phi_2717_;
continue;
continuing {
phi_2716_ = _e1513;
break if !(_e1510);
}
}
let _e1516 = local_21;
let _e1522 = local_22;
let _e1533 = local_6.member_3;
let _e1535 = local_6.member_4;
local_5 = ((_e1533 + (18u * _e1535)) + (((((1u << bitcast<u32>(((2u * _e1516) & 31u))) - (1u << bitcast<u32>(((2u * (_e1522 - _e1501)) & 31u)))) / 3u) * 4u) + _e1502));
let _e1539 = local_5;
let _e1540 = bitcast<i32>(_e1539);
let _e1542 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1544 = select(_e1542, _e1540, (_e1540 < _e1542));
let _e1549 = global_4.member[bitcast<u32>(select(0i, _e1544, (_e1544 > 0i)))];
let _e1550 = local_5;
let _e1551 = local_6.member_4;
let _e1553 = bitcast<i32>((_e1550 + _e1551));
let _e1555 = select(_e1542, _e1553, (_e1553 < _e1542));
let _e1560 = global_4.member[bitcast<u32>(select(0i, _e1555, (_e1555 > 0i)))];
let _e1561 = local_5;
let _e1562 = local_6.member_4;
let _e1565 = bitcast<i32>((_e1561 + (2u * _e1562)));
let _e1567 = select(_e1542, _e1565, (_e1565 < _e1542));
let _e1572 = global_4.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1573 = local_4.member;
let _e1574 = local_4.member_1;
let _e1575 = local_6.member;
phi_2829_ = 0u;
loop {
let _e1577 = phi_2829_;
local_23 = _e1577;
local_24 = _e1577;
let _e1581 = ((1u << bitcast<u32>((_e1577 & 31u))) < _e1575);
if _e1581 {
phi_2830_ = (_e1577 + 1u);
} else {
phi_2830_ = u32();
}
let _e1584 = phi_2830_;
continue;
continuing {
phi_2829_ = _e1584;
break if !(_e1581);
}
}
let _e1587 = local_23;
let _e1593 = local_24;
let _e1603 = local_6.member_3;
let _e1604 = local_6.member_4;
local_3 = ((_e1603 + (21u * _e1604)) + (((((1u << bitcast<u32>(((2u * _e1587) & 31u))) - (1u << bitcast<u32>(((2u * (_e1593 - _e1573)) & 31u)))) / 3u) * 4u) + _e1574));
let _e1608 = local_3;
let _e1609 = bitcast<i32>(_e1608);
let _e1611 = select(_e1542, _e1609, (_e1609 < _e1542));
let _e1616 = global_4.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = local_3;
let _e1618 = local_6.member_4;
let _e1620 = bitcast<i32>((_e1617 + _e1618));
let _e1622 = select(_e1542, _e1620, (_e1620 < _e1542));
let _e1627 = global_4.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1628 = local_3;
let _e1629 = local_6.member_4;
let _e1632 = bitcast<i32>((_e1628 + (2u * _e1629)));
let _e1634 = select(_e1542, _e1632, (_e1632 < _e1542));
let _e1639 = global_4.member[bitcast<u32>(select(0i, _e1634, (_e1634 > 0i)))];
let _e1661 = ((((_e1549 <= _e1616) && ((_e1236.member.x >= (_e1549 - 0.05f)) && (_e1236.member.x <= (_e1616 + 0.05f)))) && ((_e1236.member.y >= (_e1560 - 0.05f)) && (_e1236.member.y <= (_e1627 + 0.05f)))) && ((_e1236.member.z >= (_e1572 - 0.05f)) && (_e1236.member.z <= (_e1639 + 0.05f))));
if (_e1661 && (_e1489.member > 0u)) {
phi_4544_ = _e1487;
phi_4545_ = type_17((_e1489.member - 1u), (_e1489.member_1 << bitcast<u32>(2i)));
} else {
if _e1661 {
let _e1664 = (_e1489.member_1 & 1431655765u);
let _e1668 = ((_e1664 | (_e1664 >> bitcast<u32>(1i))) & 858993459u);
let _e1672 = ((_e1668 | (_e1668 >> bitcast<u32>(2i))) & 252645135u);
let _e1676 = ((_e1672 | (_e1672 >> bitcast<u32>(4i))) & 16711935u);
let _e1683 = ((_e1489.member_1 >> bitcast<u32>(1i)) & 1431655765u);
let _e1687 = ((_e1683 | (_e1683 >> bitcast<u32>(1i))) & 858993459u);
let _e1691 = ((_e1687 | (_e1687 >> bitcast<u32>(2i))) & 252645135u);
let _e1695 = ((_e1691 | (_e1691 >> bitcast<u32>(4i))) & 16711935u);
local = bitcast<i32>((_e1333 * _e1342));
local_1 = bitcast<i32>(((((_e1695 | (_e1695 >> bitcast<u32>(8i))) & 65535u) * _e1327) + ((_e1676 | (_e1676 >> bitcast<u32>(8i))) & 65535u)));
local_2 = bitcast<i32>((_e1327 * _e1327));
let _e1703 = local;
let _e1704 = local_1;
let _e1705 = (_e1703 + _e1704);
let _e1707 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1709 = select(_e1707, _e1705, (_e1705 < _e1707));
let _e1714 = global_3.member[bitcast<u32>(select(0i, _e1709, (_e1709 > 0i)))];
let _e1715 = local;
let _e1716 = local_2;
let _e1718 = local_1;
let _e1719 = ((_e1715 + _e1716) + _e1718);
let _e1721 = select(_e1707, _e1719, (_e1719 < _e1707));
let _e1726 = global_3.member[bitcast<u32>(select(0i, _e1721, (_e1721 > 0i)))];
let _e1727 = local;
let _e1728 = local_2;
let _e1731 = local_1;
let _e1732 = ((_e1727 + (2i * _e1728)) + _e1731);
let _e1734 = select(_e1707, _e1732, (_e1732 < _e1707));
let _e1739 = global_3.member[bitcast<u32>(select(0i, _e1734, (_e1734 > 0i)))];
let _e1740 = local;
let _e1741 = local_2;
let _e1744 = local_1;
let _e1745 = ((_e1740 + (3i * _e1741)) + _e1744);
let _e1747 = select(_e1707, _e1745, (_e1745 < _e1707));
let _e1752 = global_3.member[bitcast<u32>(select(0i, _e1747, (_e1747 > 0i)))];
let _e1753 = local;
let _e1754 = local_2;
let _e1757 = local_1;
let _e1758 = ((_e1753 + (4i * _e1754)) + _e1757);
let _e1760 = select(_e1707, _e1758, (_e1758 < _e1707));
let _e1765 = global_3.member[bitcast<u32>(select(0i, _e1760, (_e1760 > 0i)))];
let _e1766 = local;
let _e1767 = local_2;
let _e1770 = local_1;
let _e1771 = ((_e1766 + (5i * _e1767)) + _e1770);
let _e1773 = select(_e1707, _e1771, (_e1771 < _e1707));
let _e1778 = global_3.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1779 = local;
let _e1780 = local_2;
let _e1783 = local_1;
let _e1784 = ((_e1779 + (6i * _e1780)) + _e1783);
let _e1786 = select(_e1707, _e1784, (_e1784 < _e1707));
let _e1791 = global_3.member[bitcast<u32>(select(0i, _e1786, (_e1786 > 0i)))];
let _e1792 = local;
let _e1793 = local_2;
let _e1796 = local_1;
let _e1797 = ((_e1792 + (7i * _e1793)) + _e1796);
let _e1799 = select(_e1707, _e1797, (_e1797 < _e1707));
let _e1804 = global_3.member[bitcast<u32>(select(0i, _e1799, (_e1799 > 0i)))];
let _e1805 = local;
let _e1806 = local_2;
let _e1809 = local_1;
let _e1810 = ((_e1805 + (8i * _e1806)) + _e1809);
let _e1812 = select(_e1707, _e1810, (_e1810 < _e1707));
let _e1817 = global_3.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1818 = local;
let _e1819 = local_2;
let _e1822 = local_1;
let _e1823 = ((_e1818 + (9i * _e1819)) + _e1822);
let _e1825 = select(_e1707, _e1823, (_e1823 < _e1707));
let _e1830 = global_3.member[bitcast<u32>(select(0i, _e1825, (_e1825 > 0i)))];
let _e1831 = local;
let _e1832 = local_2;
let _e1835 = local_1;
let _e1836 = ((_e1831 + (10i * _e1832)) + _e1835);
let _e1838 = select(_e1707, _e1836, (_e1836 < _e1707));
let _e1843 = global_3.member[bitcast<u32>(select(0i, _e1838, (_e1838 > 0i)))];
let _e1844 = local;
let _e1845 = local_2;
let _e1848 = local_1;
let _e1849 = ((_e1844 + (11i * _e1845)) + _e1848);
let _e1851 = select(_e1707, _e1849, (_e1849 < _e1707));
let _e1856 = global_3.member[bitcast<u32>(select(0i, _e1851, (_e1851 > 0i)))];
let _e1857 = local;
let _e1858 = local_2;
let _e1861 = local_1;
let _e1862 = ((_e1857 + (12i * _e1858)) + _e1861);
let _e1864 = select(_e1707, _e1862, (_e1862 < _e1707));
let _e1869 = global_3.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1870 = local;
let _e1871 = local_2;
let _e1874 = local_1;
let _e1875 = ((_e1870 + (13i * _e1871)) + _e1874);
let _e1877 = select(_e1707, _e1875, (_e1875 < _e1707));
let _e1882 = global_3.member[bitcast<u32>(select(0i, _e1877, (_e1877 > 0i)))];
let _e1883 = local;
let _e1884 = local_2;
let _e1887 = local_1;
let _e1888 = ((_e1883 + (14i * _e1884)) + _e1887);
let _e1890 = select(_e1707, _e1888, (_e1888 < _e1707));
let _e1895 = global_3.member[bitcast<u32>(select(0i, _e1890, (_e1890 > 0i)))];
let _e1896 = local;
let _e1897 = local_2;
let _e1900 = local_1;
let _e1901 = ((_e1896 + (15i * _e1897)) + _e1900);
let _e1903 = select(_e1707, _e1901, (_e1901 < _e1707));
let _e1908 = global_3.member[bitcast<u32>(select(0i, _e1903, (_e1903 > 0i)))];
let _e1909 = local;
let _e1910 = local_2;
let _e1913 = local_1;
let _e1914 = ((_e1909 + (16i * _e1910)) + _e1913);
let _e1916 = select(_e1707, _e1914, (_e1914 < _e1707));
let _e1921 = global_3.member[bitcast<u32>(select(0i, _e1916, (_e1916 > 0i)))];
let _e1922 = local;
let _e1923 = local_2;
let _e1926 = local_1;
let _e1927 = ((_e1922 + (17i * _e1923)) + _e1926);
let _e1929 = select(_e1707, _e1927, (_e1927 < _e1707));
let _e1934 = global_3.member[bitcast<u32>(select(0i, _e1929, (_e1929 > 0i)))];
let _e1935 = local;
let _e1936 = local_2;
let _e1939 = local_1;
let _e1940 = ((_e1935 + (18i * _e1936)) + _e1939);
let _e1942 = select(_e1707, _e1940, (_e1940 < _e1707));
let _e1947 = global_3.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1948 = local;
let _e1949 = local_2;
let _e1952 = local_1;
let _e1953 = ((_e1948 + (19i * _e1949)) + _e1952);
let _e1955 = select(_e1707, _e1953, (_e1953 < _e1707));
let _e1960 = global_3.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1961 = local;
let _e1962 = local_2;
let _e1965 = local_1;
let _e1966 = ((_e1961 + (20i * _e1962)) + _e1965);
let _e1968 = select(_e1707, _e1966, (_e1966 < _e1707));
let _e1973 = global_3.member[bitcast<u32>(select(0i, _e1968, (_e1968 > 0i)))];
let _e1974 = local;
let _e1975 = local_2;
let _e1978 = local_1;
let _e1979 = ((_e1974 + (23i * _e1975)) + _e1978);
let _e1981 = select(_e1707, _e1979, (_e1979 < _e1707));
let _e1986 = global_3.member[bitcast<u32>(select(0i, _e1981, (_e1981 > 0i)))];
let _e1987 = local;
let _e1988 = local_2;
let _e1991 = local_1;
let _e1992 = ((_e1987 + (24i * _e1988)) + _e1991);
let _e1994 = select(_e1707, _e1992, (_e1992 < _e1707));
let _e1999 = global_3.member[bitcast<u32>(select(0i, _e1994, (_e1994 > 0i)))];
let _e2004 = (((_e1236.member_1.x * _e1752) + (_e1236.member_1.y * _e1765)) + (_e1236.member_1.z * _e1778));
let _e2007 = bitcast<f32>((bitcast<u32>(_e2004) & 2147483647u));
if (_e2007 < 1e-6f) {
phi_4497_ = vec3<f32>();
phi_4498_ = true;
} else {
let _e2009 = (1f / _e2004);
let _e2018 = ((((_e1236.member_1.x * (_e1236.member.x - _e1714)) + (_e1236.member_1.y * (_e1236.member.y - _e1726))) + (_e1236.member_1.z * (_e1236.member.z - _e1739))) * _e2009);
let _e2022 = (_e1791 + (_e1869 * _e2018));
let _e2023 = (_e1804 + (_e1882 * _e2018));
let _e2024 = (_e1817 + (_e1895 * _e2018));
let _e2030 = ((((_e1236.member_1.x * _e2022) + (_e1236.member_1.y * _e2023)) + (_e1236.member_1.z * _e2024)) * _e2009);
let _e2034 = (_e2022 - (_e1752 * _e2030));
let _e2035 = (_e2023 - (_e1765 * _e2030));
let _e2036 = (_e2024 - (_e1778 * _e2030));
let _e2040 = (_e1830 + (_e1908 * _e2018));
let _e2041 = (_e1843 + (_e1921 * _e2018));
let _e2042 = (_e1856 + (_e1934 * _e2018));
let _e2048 = ((((_e1236.member_1.x * _e2040) + (_e1236.member_1.y * _e2041)) + (_e1236.member_1.z * _e2042)) * _e2009);
let _e2052 = (_e2040 - (_e1752 * _e2048));
let _e2053 = (_e2041 - (_e1765 * _e2048));
let _e2054 = (_e2042 - (_e1778 * _e2048));
if ((_e2018 < -(0.05f)) || (bitcast<f32>((bitcast<u32>((_e2018 - _e1999)) & 2147483647u)) > ((0.5f * (bitcast<f32>((bitcast<u32>((((_e2034 * _e1752) + (_e2035 * _e1765)) + (_e2036 * _e1778))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2052 * _e1752) + (_e2053 * _e1765)) + (_e2054 * _e1778))) & 2147483647u)))) + 0.05f))) {
phi_4492_ = vec3<f32>();
phi_4493_ = true;
} else {
let _e2095 = (((((_e2035 * _e2054) - (_e2036 * _e2053)) * _e1236.member_1.x) + (((_e2036 * _e2052) - (_e2034 * _e2054)) * _e1236.member_1.y)) + (((_e2034 * _e2053) - (_e2035 * _e2052)) * _e1236.member_1.z));
let _e2098 = bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u));
if (_e2098 < 1e-12f) {
phi_4487_ = vec3<f32>();
phi_4488_ = true;
} else {
let _e2106 = (_e1236.member.x - (_e1714 + (_e1752 * _e2018)));
let _e2107 = (_e1236.member.y - (_e1726 + (_e1765 * _e2018)));
let _e2108 = (_e1236.member.z - (_e1739 + (_e1778 * _e2018)));
let _e2123 = ((((((_e2107 * _e2054) - (_e2108 * _e2053)) * _e1236.member_1.x) + (((_e2108 * _e2052) - (_e2106 * _e2054)) * _e1236.member_1.y)) + (((_e2106 * _e2053) - (_e2107 * _e2052)) * _e1236.member_1.z)) / _e2095);
let _e2138 = ((((((_e2035 * _e2108) - (_e2036 * _e2107)) * _e1236.member_1.x) + (((_e2036 * _e2106) - (_e2034 * _e2108)) * _e1236.member_1.y)) + (((_e2034 * _e2107) - (_e2035 * _e2106)) * _e1236.member_1.z)) / _e2095);
let _e2201 = bitcast<f32>((bitcast<u32>(((((((_e1310 * _e2054) - (_e1311 * _e2053)) * _e1236.member_1.x) + (((_e1311 * _e2052) - (_e1309 * _e2054)) * _e1236.member_1.y)) + (((_e1309 * _e2053) - (_e1310 * _e2052)) * _e1236.member_1.z)) / _e2095)) & 2147483647u));
let _e2204 = bitcast<f32>((bitcast<u32>(((((((_e1322 * _e2054) - (_e1323 * _e2053)) * _e1236.member_1.x) + (((_e1323 * _e2052) - (_e1321 * _e2054)) * _e1236.member_1.y)) + (((_e1321 * _e2053) - (_e1322 * _e2052)) * _e1236.member_1.z)) / _e2095)) & 2147483647u));
let _e2206 = select(_e2204, _e2201, (_e2201 > _e2204));
let _e2208 = select(1e-3f, _e2206, (_e2206 > 1e-3f));
let _e2211 = bitcast<f32>((bitcast<u32>(((((((_e2035 * _e1311) - (_e2036 * _e1310)) * _e1236.member_1.x) + (((_e2036 * _e1309) - (_e2034 * _e1311)) * _e1236.member_1.y)) + (((_e2034 * _e1310) - (_e2035 * _e1309)) * _e1236.member_1.z)) / _e2095)) & 2147483647u));
let _e2214 = bitcast<f32>((bitcast<u32>(((((((_e2035 * _e1323) - (_e2036 * _e1322)) * _e1236.member_1.x) + (((_e2036 * _e1321) - (_e2034 * _e1323)) * _e1236.member_1.y)) + (((_e2034 * _e1322) - (_e2035 * _e1321)) * _e1236.member_1.z)) / _e2095)) & 2147483647u));
let _e2216 = select(_e2214, _e2211, (_e2211 > _e2214));
let _e2218 = select(1e-3f, _e2216, (_e2216 > 1e-3f));
let _e2231 = ((bitcast<f32>((bitcast<u32>(_e2123) & 2147483647u)) > (0.5f * (1f + _e2208))) || (bitcast<f32>((bitcast<u32>(_e2138) & 2147483647u)) > (0.5f * (1f + _e2218))));
if _e2231 {
phi_4486_ = vec3<f32>();
} else {
let _e2232 = (1e-4f * _e2208);
let _e2234 = select(_e2232, 1f, (1f > _e2232));
let _e2236 = select(_e2232, 1e-4f, (1e-4f > _e2232));
let _e2237 = (0.5f * _e2208);
let _e2238 = (_e2123 + _e2237);
let _e2239 = -(_e2238);
let _e2243 = (0.5f * (_e2234 + _e2236));
let _e2244 = (_e2243 - select(_e2239, _e2238, (_e2238 > _e2239)));
let _e2246 = select(0f, _e2244, (_e2244 > 0f));
let _e2248 = select(_e2236, _e2246, (_e2246 < _e2236));
let _e2252 = (_e2244 - _e2236);
let _e2256 = ((((_e2248 * (_e2248 / _e2236)) * 0.5f) + select(0f, _e2252, (_e2252 > 0f))) / _e2234);
let _e2260 = (_e2123 - _e2237);
let _e2261 = -(_e2260);
let _e2264 = (_e2243 - select(_e2261, _e2260, (_e2260 > _e2261)));
let _e2266 = select(0f, _e2264, (_e2264 > 0f));
let _e2268 = select(_e2236, _e2266, (_e2266 < _e2236));
let _e2272 = (_e2264 - _e2236);
let _e2276 = ((((_e2268 * (_e2268 / _e2236)) * 0.5f) + select(0f, _e2272, (_e2272 > 0f))) / _e2234);
let _e2282 = (1e-4f * _e2218);
let _e2284 = select(_e2282, 1f, (1f > _e2282));
let _e2286 = select(_e2282, 1e-4f, (1e-4f > _e2282));
let _e2287 = (0.5f * _e2218);
let _e2288 = (_e2138 + _e2287);
let _e2289 = -(_e2288);
let _e2293 = (0.5f * (_e2284 + _e2286));
let _e2294 = (_e2293 - select(_e2289, _e2288, (_e2288 > _e2289)));
let _e2296 = select(0f, _e2294, (_e2294 > 0f));
let _e2298 = select(_e2286, _e2296, (_e2296 < _e2286));
let _e2302 = (_e2294 - _e2286);
let _e2306 = ((((_e2298 * (_e2298 / _e2286)) * 0.5f) + select(0f, _e2302, (_e2302 > 0f))) / _e2284);
let _e2310 = (_e2138 - _e2287);
let _e2311 = -(_e2310);
let _e2314 = (_e2293 - select(_e2311, _e2310, (_e2310 > _e2311)));
let _e2316 = select(0f, _e2314, (_e2314 > 0f));
let _e2318 = select(_e2286, _e2316, (_e2316 < _e2286));
let _e2322 = (_e2314 - _e2286);
let _e2326 = ((((_e2318 * (_e2318 / _e2286)) * 0.5f) + select(0f, _e2322, (_e2322 > 0f))) / _e2284);
let _e2335 = select(_e1986, _e2018, (_e2018 < _e1986));
let _e2348 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1236.member_2.x * _e1752) + (_e1236.member_2.y * _e1765)) + (_e1236.member_2.z * _e1778))) & 2147483647u)));
let _e2355 = (((_e1236.member_1.x * _e438) + (_e1236.member_1.y * _e449)) + (_e1236.member_1.z * _e460));
let _e2357 = select(1f, -1f, (_e2355 > 0f));
let _e2365 = select(_e2357, -(_e2357), ((((_e1236.member_2.x * _e1236.member_1.x) + (_e1236.member_2.y * _e1236.member_1.y)) + (_e1236.member_2.z * _e1236.member_1.z)) < 0f));
let _e2366 = (_e1236.member_2.x * _e2365);
let _e2367 = (_e1236.member_2.y * _e2365);
let _e2368 = (_e1236.member_2.z * _e2365);
let _e2377 = ((((_e2366 * _e438) + (_e2367 * _e449)) + (_e2368 * _e460)) > 0f);
let _e2386 = -((((select(_e2366, (_e1236.member_1.x * _e2357), _e2377) * _e1752) + (select(_e2367, (_e1236.member_1.y * _e2357), _e2377) * _e1765)) + (select(_e2368, (_e1236.member_1.z * _e2357), _e2377) * _e1778)));
let _e2391 = -(_e2386);
let _e2401 = global_1.member.member_13.member;
let _e2406 = -((_e2401.member * _e2335));
let _e2408 = select(-87f, _e2406, (_e2406 > -87f));
let _e2410 = select(88f, _e2408, (_e2408 < 88f));
let _e2412 = ((_e2410 * 1.442695f) + 0.5f);
let _e2414 = select(-127f, _e2412, (_e2412 > -127f));
let _e2416 = select(128f, _e2414, (_e2414 < 128f));
let _e2423 = select(0i, select(select(i32(_e2416), i32(-2147483648), (_e2416 < -2147483600f)), 2147483647i, (_e2416 > 2147483500f)), (_e2416 == _e2416));
let _e2427 = (_e2423 - select(0i, 1i, (_e2416 < f32(_e2423))));
let _e2428 = f32(_e2427);
let _e2432 = ((_e2410 - (_e2428 * 0.6933594f)) - (_e2428 * -2.1219444e-4f));
let _e2454 = -((_e2401.member_1 * _e2335));
let _e2456 = select(-87f, _e2454, (_e2454 > -87f));
let _e2458 = select(88f, _e2456, (_e2456 < 88f));
let _e2460 = ((_e2458 * 1.442695f) + 0.5f);
let _e2462 = select(-127f, _e2460, (_e2460 > -127f));
let _e2464 = select(128f, _e2462, (_e2462 < 128f));
let _e2471 = select(0i, select(select(i32(_e2464), i32(-2147483648), (_e2464 < -2147483600f)), 2147483647i, (_e2464 > 2147483500f)), (_e2464 == _e2464));
let _e2475 = (_e2471 - select(0i, 1i, (_e2464 < f32(_e2471))));
let _e2476 = f32(_e2475);
let _e2480 = ((_e2458 - (_e2476 * 0.6933594f)) - (_e2476 * -2.1219444e-4f));
let _e2502 = -((_e2401.member_2 * _e2335));
let _e2504 = select(-87f, _e2502, (_e2502 > -87f));
let _e2506 = select(88f, _e2504, (_e2504 < 88f));
let _e2508 = ((_e2506 * 1.442695f) + 0.5f);
let _e2510 = select(-127f, _e2508, (_e2508 > -127f));
let _e2512 = select(128f, _e2510, (_e2510 < 128f));
let _e2519 = select(0i, select(select(i32(_e2512), i32(-2147483648), (_e2512 < -2147483600f)), 2147483647i, (_e2512 > 2147483500f)), (_e2512 == _e2512));
let _e2523 = (_e2519 - select(0i, 1i, (_e2512 < f32(_e2519))));
let _e2524 = f32(_e2523);
let _e2528 = ((_e2506 - (_e2524 * 0.6933594f)) - (_e2524 * -2.1219444e-4f));
let _e2554 = ((((((select(_e2256, (1f - _e2256), (_e2238 >= 0f)) - select(_e2276, (1f - _e2276), (_e2260 >= 0f))) / _e2208) * ((select(_e2306, (1f - _e2306), (_e2288 >= 0f)) - select(_e2326, (1f - _e2326), (_e2310 >= 0f))) / _e2218)) / _e2098) * (select((select(0f, _e2391, (_e2391 > 0f)) * _e1236.member_4), select(0f, _e2386, (_e2386 > 0f)), ((_e2004 * _e2355) > 0f)) / select(_e2348, _e2007, (_e2007 > _e2348)))) * (1f / 3.1415927f));
phi_4486_ = vec3<f32>(((_e1947 * ((1f + (_e2432 * (1f + (_e2432 * (0.5f + (_e2432 * (0.16666667f + (_e2432 * (0.041666668f + (_e2432 * (0.008333334f + (_e2432 * (0.001388889f + (_e2432 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2427 + 127i)) << bitcast<u32>(23i))))) * _e2554), ((_e1960 * ((1f + (_e2480 * (1f + (_e2480 * (0.5f + (_e2480 * (0.16666667f + (_e2480 * (0.041666668f + (_e2480 * (0.008333334f + (_e2480 * (0.001388889f + (_e2480 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2475 + 127i)) << bitcast<u32>(23i))))) * _e2554), ((_e1973 * ((1f + (_e2528 * (1f + (_e2528 * (0.5f + (_e2528 * (0.16666667f + (_e2528 * (0.041666668f + (_e2528 * (0.008333334f + (_e2528 * (0.001388889f + (_e2528 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2523 + 127i)) << bitcast<u32>(23i))))) * _e2554));
}
let _e2560 = phi_4486_;
phi_4487_ = _e2560;
phi_4488_ = _e2231;
}
let _e2562 = phi_4487_;
let _e2564 = phi_4488_;
phi_4492_ = _e2562;
phi_4493_ = _e2564;
}
let _e2566 = phi_4492_;
let _e2568 = phi_4493_;
phi_4497_ = _e2566;
phi_4498_ = _e2568;
}
let _e2570 = phi_4497_;
let _e2572 = phi_4498_;
phi_4514_ = (_e1487 + select(_e2570, vec3<f32>(0f, 0f, 0f), vec3(_e2572)));
} else {
phi_4514_ = _e1487;
}
let _e2577 = phi_4514_;
let _e2578 = local_6.member_1;
phi_4522_ = type_17(_e1489.member, (_e1489.member_1 + 1u));
loop {
let _e2582 = phi_4522_;
local_28 = _e2582;
let _e2588 = (((_e2582.member_1 & 3u) == 0u) && (_e2582.member < _e2578));
if _e2588 {
phi_4523_ = type_17((_e2582.member + 1u), (_e2582.member_1 >> bitcast<u32>(2i)));
} else {
phi_4523_ = type_17();
}
let _e2594 = phi_4523_;
continue;
continuing {
phi_4522_ = _e2594;
break if !(_e2588);
}
}
phi_4544_ = _e2577;
let _e2980 = local_28;
phi_4545_ = _e2980;
}
let _e2601 = phi_4544_;
let _e2603 = phi_4545_;
phi_2679_ = _e2601;
phi_2682_ = _e2603;
} else {
phi_2679_ = vec3<f32>();
phi_2682_ = type_17();
}
let _e2605 = phi_2679_;
let _e2607 = phi_2682_;
continue;
continuing {
phi_2678_ = _e2605;
phi_2681_ = _e2607;
break if !(_e1497);
}
}
let _e2985 = local_29;
phi_2495_ = _e2985;
phi_2498_ = (_e1333 + 1u);
} else {
phi_2495_ = vec3<f32>();
phi_2498_ = u32();
}
let _e2611 = phi_2495_;
let _e2613 = phi_2498_;
continue;
continuing {
phi_2494_ = _e2611;
phi_2497_ = _e2613;
break if !(_e1338);
}
}
let _e2622 = (1f / select(_e438, select(1e-12f, -1e-12f, (_e438 < 0f)), (bitcast<f32>((bitcast<u32>(_e438) & 2147483647u)) < 1e-12f)));
let _e2630 = (1f / select(_e449, select(1e-12f, -1e-12f, (_e449 < 0f)), (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) < 1e-12f)));
let _e2638 = (1f / select(_e460, select(1e-12f, -1e-12f, (_e460 < 0f)), (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) < 1e-12f)));
let _e2642 = global_1.member.member_13.member_4;
let _e2649 = global_1.member.member_13.member_5;
let _e2654 = ((_e2642.member - _e755) * _e2622);
let _e2656 = ((_e2649.member - _e755) * _e2622);
let _e2658 = ((_e2642.member_1 - _e756) * _e2630);
let _e2660 = ((_e2649.member_1 - _e756) * _e2630);
let _e2662 = ((_e2642.member_2 - _e757) * _e2638);
let _e2664 = ((_e2649.member_2 - _e757) * _e2638);
let _e2666 = select(_e2656, _e2654, (_e2654 < _e2656));
let _e2668 = select(_e2660, _e2658, (_e2658 < _e2660));
let _e2670 = select(_e2668, _e2666, (_e2666 > _e2668));
let _e2672 = select(_e2664, _e2662, (_e2662 < _e2664));
let _e2674 = select(_e2672, _e2670, (_e2670 > _e2672));
let _e2676 = select(_e2656, _e2654, (_e2654 > _e2656));
let _e2678 = select(_e2660, _e2658, (_e2658 > _e2660));
let _e2680 = select(_e2678, _e2676, (_e2676 < _e2678));
let _e2682 = select(_e2664, _e2662, (_e2662 > _e2664));
let _e2684 = select(_e2682, _e2680, (_e2680 < _e2682));
let _e2686 = select(0f, _e2674, (_e2674 > 0f));
let _e2688 = select(_e758, _e2684, (_e2684 < _e758));
let _e2691 = (select(_e2686, _e2688, (_e2688 > _e2686)) - _e2686);
let _e2695 = global_1.member.member_13.member;
let _e2700 = -((_e2695.member * _e2691));
let _e2702 = select(-87f, _e2700, (_e2700 > -87f));
let _e2704 = select(88f, _e2702, (_e2702 < 88f));
let _e2706 = ((_e2704 * 1.442695f) + 0.5f);
let _e2708 = select(-127f, _e2706, (_e2706 > -127f));
let _e2710 = select(128f, _e2708, (_e2708 < 128f));
let _e2717 = select(0i, select(select(i32(_e2710), i32(-2147483648), (_e2710 < -2147483600f)), 2147483647i, (_e2710 > 2147483500f)), (_e2710 == _e2710));
let _e2721 = (_e2717 - select(0i, 1i, (_e2710 < f32(_e2717))));
let _e2722 = f32(_e2721);
let _e2726 = ((_e2704 - (_e2722 * 0.6933594f)) - (_e2722 * -2.1219444e-4f));
let _e2748 = -((_e2695.member_1 * _e2691));
let _e2750 = select(-87f, _e2748, (_e2748 > -87f));
let _e2752 = select(88f, _e2750, (_e2750 < 88f));
let _e2754 = ((_e2752 * 1.442695f) + 0.5f);
let _e2756 = select(-127f, _e2754, (_e2754 > -127f));
let _e2758 = select(128f, _e2756, (_e2756 < 128f));
let _e2765 = select(0i, select(select(i32(_e2758), i32(-2147483648), (_e2758 < -2147483600f)), 2147483647i, (_e2758 > 2147483500f)), (_e2758 == _e2758));
let _e2769 = (_e2765 - select(0i, 1i, (_e2758 < f32(_e2765))));
let _e2770 = f32(_e2769);
let _e2774 = ((_e2752 - (_e2770 * 0.6933594f)) - (_e2770 * -2.1219444e-4f));
let _e2796 = -((_e2695.member_2 * _e2691));
let _e2798 = select(-87f, _e2796, (_e2796 > -87f));
let _e2800 = select(88f, _e2798, (_e2798 < 88f));
let _e2802 = ((_e2800 * 1.442695f) + 0.5f);
let _e2804 = select(-127f, _e2802, (_e2802 > -127f));
let _e2806 = select(128f, _e2804, (_e2804 < 128f));
let _e2813 = select(0i, select(select(i32(_e2806), i32(-2147483648), (_e2806 < -2147483600f)), 2147483647i, (_e2806 > 2147483500f)), (_e2806 == _e2806));
let _e2817 = (_e2813 - select(0i, 1i, (_e2806 < f32(_e2813))));
let _e2818 = f32(_e2817);
let _e2822 = ((_e2800 - (_e2818 * 0.6933594f)) - (_e2818 * -2.1219444e-4f));
let _e2845 = local_25;
let _e2850 = local_26;
let _e2855 = local_27;
phi_4913_ = array<f32, 18>(_e156, _e166, (_e177 + (((_e2845.x * _e1236.member_3.x) * ((1f + (_e2726 * (1f + (_e2726 * (0.5f + (_e2726 * (0.16666667f + (_e2726 * (0.041666668f + (_e2726 * (0.008333334f + (_e2726 * (0.001388889f + (_e2726 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2721 + 127i)) << bitcast<u32>(23i))))) * select(_e603, 1f, _e673))), (_e188 + (((_e2850.y * _e1236.member_3.y) * ((1f + (_e2774 * (1f + (_e2774 * (0.5f + (_e2774 * (0.16666667f + (_e2774 * (0.041666668f + (_e2774 * (0.008333334f + (_e2774 * (0.001388889f + (_e2774 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2769 + 127i)) << bitcast<u32>(23i))))) * select(_e614, 1f, _e673))), (_e199 + (((_e2855.z * _e1236.member_3.z) * ((1f + (_e2822 * (1f + (_e2822 * (0.5f + (_e2822 * (0.16666667f + (_e2822 * (0.041666668f + (_e2822 * (0.008333334f + (_e2822 * (0.001388889f + (_e2822 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2817 + 127i)) << bitcast<u32>(23i))))) * select(_e625, 1f, _e673))), _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342);
} else {
phi_4913_ = array<f32, 18>(_e156, _e166, _e177, _e188, _e199, _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342);
}
let _e2870 = phi_4913_;
global_5.member[_e145] = _e2870[0];
global_5.member[_e157] = _e2870[1];
global_5.member[_e168] = _e2870[2];
global_5.member[_e179] = _e2870[3];
global_5.member[_e190] = _e2870[4];
global_5.member[_e201] = _e2870[5];
global_5.member[_e212] = _e2870[6];
global_5.member[_e223] = _e2870[7];
global_5.member[_e234] = _e2870[8];
global_5.member[_e245] = _e2870[9];
global_5.member[_e256] = _e2870[10];
global_5.member[_e267] = _e2870[11];
global_5.member[_e278] = _e2870[12];
global_5.member[_e289] = _e2870[13];
global_5.member[_e300] = _e2870[14];
global_5.member[_e311] = _e2870[15];
global_5.member[_e322] = _e2870[16];
global_5.member[_e333] = _e2870[17];
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
