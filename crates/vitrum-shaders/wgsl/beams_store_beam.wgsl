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
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
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
struct type_18 {
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
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_20 {
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
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage, read_write> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
fn function_() {
var local: i32;
var phi_2170_: vec3<f32>;
var phi_2173_: vec3<f32>;
var phi_2186_: type_23;
var phi_2193_: vec3<f32>;
let _e69 = global;
let _e77 = global_1.member.member;
if (_e69.x < _e77.member) {
if (_e69.y < _e77.member_1) {
let _e84 = (_e77.member * _e77.member_1);
let _e86 = ((_e69.y * _e77.member) + _e69.x);
let _e91 = global_1.member.member.member;
let _e95 = global_1.member.member.member_1;
let _e96 = (_e91 * _e95);
let _e98 = ((_e69.y * _e91) + _e69.x);
let _e99 = bitcast<i32>(_e98);
let _e101 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e103 = select(_e101, _e99, (_e99 < _e101));
let _e109 = global_2.member[bitcast<u32>(select(0i, _e103, (_e103 > 0i)))];
let _e111 = bitcast<i32>((_e96 + _e98));
let _e113 = select(_e101, _e111, (_e111 < _e101));
let _e119 = global_2.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e122 = bitcast<i32>(((2u * _e96) + _e98));
let _e124 = select(_e101, _e122, (_e122 < _e101));
let _e130 = global_2.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e133 = bitcast<i32>(((3u * _e96) + _e98));
let _e135 = select(_e101, _e133, (_e133 < _e101));
let _e141 = global_2.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e144 = bitcast<i32>(((4u * _e96) + _e98));
let _e146 = select(_e101, _e144, (_e144 < _e101));
let _e152 = global_2.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e155 = bitcast<i32>(((5u * _e96) + _e98));
let _e157 = select(_e101, _e155, (_e155 < _e101));
let _e163 = global_2.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e166 = bitcast<i32>(((6u * _e96) + _e98));
let _e168 = select(_e101, _e166, (_e166 < _e101));
let _e174 = global_2.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e177 = bitcast<i32>(((7u * _e96) + _e98));
let _e179 = select(_e101, _e177, (_e177 < _e101));
let _e185 = global_2.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e188 = bitcast<i32>(((8u * _e96) + _e98));
let _e190 = select(_e101, _e188, (_e188 < _e101));
let _e196 = global_2.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e199 = bitcast<i32>(((9u * _e96) + _e98));
let _e201 = select(_e101, _e199, (_e199 < _e101));
let _e207 = global_2.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e210 = bitcast<i32>(((10u * _e96) + _e98));
let _e212 = select(_e101, _e210, (_e210 < _e101));
let _e218 = global_2.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e221 = bitcast<i32>(((11u * _e96) + _e98));
let _e223 = select(_e101, _e221, (_e221 < _e101));
let _e229 = global_2.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e232 = bitcast<i32>(((12u * _e96) + _e98));
let _e234 = select(_e101, _e232, (_e232 < _e101));
let _e240 = global_2.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e243 = bitcast<i32>(((13u * _e96) + _e98));
let _e245 = select(_e101, _e243, (_e243 < _e101));
let _e251 = global_2.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e254 = bitcast<i32>(((14u * _e96) + _e98));
let _e256 = select(_e101, _e254, (_e254 < _e101));
let _e262 = global_2.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e265 = bitcast<i32>(((15u * _e96) + _e98));
let _e267 = select(_e101, _e265, (_e265 < _e101));
let _e273 = global_2.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e276 = bitcast<i32>(((16u * _e96) + _e98));
let _e278 = select(_e101, _e276, (_e276 < _e101));
let _e284 = global_2.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e287 = bitcast<i32>(((17u * _e96) + _e98));
let _e289 = select(_e101, _e287, (_e287 < _e101));
let _e295 = global_2.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e298 = bitcast<i32>(((18u * _e96) + _e98));
let _e300 = select(_e101, _e298, (_e298 < _e101));
let _e306 = global_2.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e309 = bitcast<i32>(((19u * _e96) + _e98));
let _e311 = select(_e101, _e309, (_e309 < _e101));
let _e317 = global_2.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e320 = bitcast<i32>(((20u * _e96) + _e98));
let _e322 = select(_e101, _e320, (_e320 < _e101));
let _e328 = global_2.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e331 = bitcast<i32>(((23u * _e96) + _e98));
let _e333 = select(_e101, _e331, (_e331 < _e101));
let _e339 = global_2.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e342 = bitcast<i32>(((24u * _e96) + _e98));
let _e344 = select(_e101, _e342, (_e342 < _e101));
let _e350 = global_2.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e353 = bitcast<i32>(((29u * _e96) + _e98));
let _e355 = select(_e101, _e353, (_e353 < _e101));
let _e361 = global_2.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e364 = bitcast<i32>(((30u * _e96) + _e98));
let _e366 = select(_e101, _e364, (_e364 < _e101));
let _e372 = global_2.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e375 = bitcast<i32>(((36u * _e96) + _e98));
let _e377 = select(_e101, _e375, (_e375 < _e101));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e390 = select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < -2147483600f)), 2147483647i, (_e339 > 2147483500f)), (_e339 == _e339));
let _e406 = (_e77.member_2 == 1u);
let _e411 = global_1.member.member_12.member_4;
let _e421 = ((((_e361 == 2f) && (select(0i, select(select(i32(_e383), i32(-2147483648), (_e383 < -2147483600f)), 2147483647i, (_e383 > 2147483500f)), (_e383 == _e383)) == (bitcast<i32>(_e411) + 1i))) && ((select(0i, select(select(i32(_e372), i32(-2147483648), (_e372 < -2147483600f)), 2147483647i, (_e372 > 2147483500f)), (_e372 == _e372)) == 0i) == _e406)) && (!(_e406) || (_e390 >= 0i)));
let _e422 = select(0f, _e350, _e406);
let _e423 = select(_e350, 1e30f, _e406);
let _e431 = (1f / select(_e141, select(1e-12f, -1e-12f, (_e141 < 0f)), (bitcast<f32>((bitcast<u32>(_e141) & 2147483647u)) < 1e-12f)));
let _e439 = (1f / select(_e152, select(1e-12f, -1e-12f, (_e152 < 0f)), (bitcast<f32>((bitcast<u32>(_e152) & 2147483647u)) < 1e-12f)));
let _e447 = (1f / select(_e163, select(1e-12f, -1e-12f, (_e163 < 0f)), (bitcast<f32>((bitcast<u32>(_e163) & 2147483647u)) < 1e-12f)));
let _e451 = global_1.member.member_13.member_4;
let _e458 = global_1.member.member_13.member_5;
let _e463 = ((_e451.member - _e109) * _e431);
let _e465 = ((_e458.member - _e109) * _e431);
let _e467 = ((_e451.member_1 - _e119) * _e439);
let _e469 = ((_e458.member_1 - _e119) * _e439);
let _e471 = ((_e451.member_2 - _e130) * _e447);
let _e473 = ((_e458.member_2 - _e130) * _e447);
let _e475 = select(_e465, _e463, (_e463 < _e465));
let _e477 = select(_e469, _e467, (_e467 < _e469));
let _e479 = select(_e477, _e475, (_e475 > _e477));
let _e481 = select(_e473, _e471, (_e471 < _e473));
let _e483 = select(_e481, _e479, (_e479 > _e481));
let _e485 = select(_e465, _e463, (_e463 > _e465));
let _e487 = select(_e469, _e467, (_e467 > _e469));
let _e489 = select(_e487, _e485, (_e485 < _e487));
let _e491 = select(_e473, _e471, (_e471 > _e473));
let _e493 = select(_e491, _e489, (_e489 < _e491));
let _e495 = select(_e422, _e483, (_e483 > _e422));
let _e497 = select(_e423, _e493, (_e493 < _e423));
let _e498 = (_e497 > _e495);
let _e499 = select(_e422, _e495, _e498);
let _e505 = (((_e240 * _e240) + (_e251 * _e251)) + (_e262 * _e262));
let _e508 = sqrt(select(0f, _e505, (_e505 > 0f)));
let _e511 = (0.5f / select(1e-20f, _e508, (_e508 > 1e-20f)));
let _e513 = select(_e511, 1f, (1f < _e511));
let _e514 = (_e240 * _e513);
let _e515 = (_e251 * _e513);
let _e516 = (_e262 * _e513);
let _e521 = (((_e273 * _e273) + (_e284 * _e284)) + (_e295 * _e295));
let _e524 = sqrt(select(0f, _e521, (_e521 > 0f)));
let _e527 = (0.5f / select(1e-20f, _e524, (_e524 > 1e-20f)));
let _e529 = select(_e527, 1f, (1f < _e527));
let _e530 = (_e273 * _e529);
let _e531 = (_e284 * _e529);
let _e532 = (_e295 * _e529);
let _e536 = (_e174 + (_e514 * _e499));
let _e537 = (_e185 + (_e515 * _e499));
let _e538 = (_e196 + (_e516 * _e499));
let _e542 = (_e207 + (_e530 * _e499));
let _e543 = (_e218 + (_e531 * _e499));
let _e544 = (_e229 + (_e532 * _e499));
let _e550 = global_1.member.member_11.member_2;
let _e557 = global_1.member.member_11.member_3;
let _e564 = global_1.member.member_11.member_5;
let _e570 = global_1.member.member_11.member_7;
let _e572 = (_e564 + ((f32(bitcast<i32>(_e69.x)) + 0.5f) * _e570));
let _e576 = global_1.member.member_11.member_6;
let _e582 = global_1.member.member_11.member_8;
let _e584 = (_e576 + ((f32(bitcast<i32>(_e69.y)) + 0.5f) * _e582));
let _e597 = global_1.member.member_11.member_1;
let _e604 = global_1.member.member_10.member;
let _e605 = (_e604 == 0u);
let _e606 = (_e597.member + ((_e550.member * _e572) + (_e557.member * _e584)));
let _e607 = (_e597.member_1 + ((_e550.member_1 * _e572) + (_e557.member_1 * _e584)));
let _e608 = (_e597.member_2 + ((_e550.member_2 * _e572) + (_e557.member_2 * _e584)));
let _e613 = (((_e606 * _e606) + (_e607 * _e607)) + (_e608 * _e608));
let _e617 = (1f / sqrt(select(0f, _e613, (_e613 > 0f))));
let _e621 = select((_e606 * _e617), _e597.member, _e605);
let _e622 = select((_e607 * _e617), _e597.member_1, _e605);
let _e623 = select((_e608 * _e617), _e597.member_2, _e605);
let _e625 = select(0f, _e483, (_e483 > 0f));
let _e627 = select(_e499, _e493, (_e493 < _e499));
let _e628 = (_e627 > _e625);
let _e631 = (select(0f, _e627, _e628) - select(0f, _e625, _e628));
let _e633 = select(0f, _e631, (_e631 > 0f));
let _e637 = global_1.member.member_13.member;
let _e642 = -((_e637.member * _e633));
let _e644 = select(-87f, _e642, (_e642 > -87f));
let _e646 = select(88f, _e644, (_e644 < 88f));
let _e648 = ((_e646 * 1.442695f) + 0.5f);
let _e650 = select(-127f, _e648, (_e648 > -127f));
let _e652 = select(128f, _e650, (_e650 < 128f));
let _e659 = select(0i, select(select(i32(_e652), i32(-2147483648), (_e652 < -2147483600f)), 2147483647i, (_e652 > 2147483500f)), (_e652 == _e652));
let _e663 = (_e659 - select(0i, 1i, (_e652 < f32(_e659))));
let _e664 = f32(_e663);
let _e668 = ((_e646 - (_e664 * 0.6933594f)) - (_e664 * -2.1219444e-4f));
let _e690 = -((_e637.member_1 * _e633));
let _e692 = select(-87f, _e690, (_e690 > -87f));
let _e694 = select(88f, _e692, (_e692 < 88f));
let _e696 = ((_e694 * 1.442695f) + 0.5f);
let _e698 = select(-127f, _e696, (_e696 > -127f));
let _e700 = select(128f, _e698, (_e698 < 128f));
let _e707 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < -2147483600f)), 2147483647i, (_e700 > 2147483500f)), (_e700 == _e700));
let _e711 = (_e707 - select(0i, 1i, (_e700 < f32(_e707))));
let _e712 = f32(_e711);
let _e716 = ((_e694 - (_e712 * 0.6933594f)) - (_e712 * -2.1219444e-4f));
let _e738 = -((_e637.member_2 * _e633));
let _e740 = select(-87f, _e738, (_e738 > -87f));
let _e742 = select(88f, _e740, (_e740 < 88f));
let _e744 = ((_e742 * 1.442695f) + 0.5f);
let _e746 = select(-127f, _e744, (_e744 > -127f));
let _e748 = select(128f, _e746, (_e746 < 128f));
let _e755 = select(0i, select(select(i32(_e748), i32(-2147483648), (_e748 < -2147483600f)), 2147483647i, (_e748 > 2147483500f)), (_e748 == _e748));
let _e759 = (_e755 - select(0i, 1i, (_e748 < f32(_e755))));
let _e760 = f32(_e759);
let _e764 = ((_e742 - (_e760 * 0.6933594f)) - (_e760 * -2.1219444e-4f));
let _e785 = (_e570 * _e582);
if _e605 {
let _e789 = global_1.member.member_10.member_2;
let _e793 = (3.1415927f * _e785);
phi_2193_ = vec3<f32>((_e789.member * _e793), (_e789.member_1 * _e793), (_e789.member_2 * _e793));
} else {
let _e802 = (((_e621 * _e597.member) + (_e622 * _e597.member_1)) + (_e623 * _e597.member_2));
let _e806 = global_1.member.member_11.member_4;
let _e816 = global_1.member.member_10.member_2;
if _e605 {
let _e824 = global_1.member.member_10.member_1;
phi_2186_ = type_23(vec3<f32>(_e824.member, _e824.member_1, _e824.member_2), vec3<f32>(_e816.member, _e816.member_1, _e816.member_2));
} else {
let _e833 = global_1.member.member_10.member_3;
let _e837 = ((_e806.member + _e621) - _e833.member);
let _e838 = ((_e806.member_1 + _e622) - _e833.member_1);
let _e839 = ((_e806.member_2 + _e623) - _e833.member_2);
let _e844 = (((_e837 * _e837) + (_e838 * _e838)) + (_e839 * _e839));
let _e846 = select(1e-12f, _e844, (_e844 > 1e-12f));
let _e847 = (1f / _e846);
let _e851 = vec3<f32>((_e816.member * _e847), (_e816.member_1 * _e847), (_e816.member_2 * _e847));
if (_e604 == 2u) {
let _e856 = global_1.member.member_10.member_1;
let _e864 = (((_e856.member * _e837) + (_e856.member_1 * _e838)) + (_e856.member_2 * _e839));
let _e867 = (1f / select(1e-20f, _e864, (_e864 > 1e-20f)));
let _e872 = global_1.member.member_10.member_4.member;
let _e881 = ((((_e872.member * _e837) + (_e872.member_1 * _e838)) + (_e872.member_2 * _e839)) * _e867);
let _e886 = global_1.member.member_10.member_4.member_1;
let _e895 = ((((_e886.member * _e837) + (_e886.member_1 * _e838)) + (_e886.member_2 * _e839)) * _e867);
let _e900 = global_1.member.member_10.member_4.member_2;
let _e903 = ((_e881 * _e881) + (_e895 * _e895));
let _e912 = global_1.member.member_10.member_4.member_3;
let _e913 = ((_e900 - sqrt(select(0f, _e903, (_e903 > 0f)))) * _e912);
let _e915 = select(0f, _e913, (_e913 > 0f));
let _e917 = select(1f, _e915, (_e915 < 1f));
let _e923 = select(0f, ((_e917 * _e917) * (3f - (2f * _e917))), (_e864 > 0f));
let _e928 = global_1.member.member_10.member_4.member_5;
if ((_e928 > 0u) && (_e923 > 0f)) {
let _e932 = (0.5f / _e900);
let _e942 = global_1.member.member_10.member_4.member_6;
let _e943 = bitcast<i32>(_e942);
local = bitcast<i32>(_e928);
let _e944 = local;
let _e946 = f32((_e944 - 1i));
let _e948 = f32((_e943 - 1i));
let _e949 = local;
let _e952 = (((0.5f + (_e881 * _e932)) * f32(_e949)) - 0.5f);
let _e954 = select(0f, _e952, (_e952 > 0f));
let _e956 = select(_e946, _e954, (_e954 < _e946));
let _e959 = (((0.5f - (_e895 * _e932)) * f32(_e943)) - 0.5f);
let _e961 = select(0f, _e959, (_e959 > 0f));
let _e963 = select(_e948, _e961, (_e961 < _e948));
let _e965 = select(0f, _e956, (_e956 > 0f));
let _e967 = select(_e946, _e965, (_e965 < _e946));
let _e974 = select(0i, select(select(i32(_e967), i32(-2147483648), (_e967 < -2147483600f)), 2147483647i, (_e967 > 2147483500f)), (_e967 == _e967));
let _e978 = (_e974 - select(0i, 1i, (_e967 < f32(_e974))));
let _e980 = select(0f, _e963, (_e963 > 0f));
let _e982 = select(_e948, _e980, (_e980 < _e948));
let _e989 = select(0i, select(select(i32(_e982), i32(-2147483648), (_e982 < -2147483600f)), 2147483647i, (_e982 > 2147483500f)), (_e982 == _e982));
let _e993 = (_e989 - select(0i, 1i, (_e982 < f32(_e989))));
let _e995 = (_e956 - f32(_e978));
let _e997 = (_e963 - f32(_e993));
let _e998 = (_e978 + 1i);
let _e999 = local;
let _e1001 = select(_e978, _e998, (_e998 < _e999));
let _e1002 = (_e993 + 1i);
let _e1004 = select(_e993, _e1002, (_e1002 < _e943));
let _e1009 = global_1.member.member_10.member_4.member_4;
let _e1010 = bitcast<i32>(_e1009);
let _e1011 = local;
let _e1015 = (_e1010 + (3i * ((_e993 * _e1011) + _e978)));
let _e1017 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1019 = select(_e1017, _e1015, (_e1015 < _e1017));
let _e1024 = global_4.member[bitcast<u32>(select(0i, _e1019, (_e1019 > 0i)))];
let _e1025 = (_e1015 + 1i);
let _e1027 = select(_e1017, _e1025, (_e1025 < _e1017));
let _e1032 = global_4.member[bitcast<u32>(select(0i, _e1027, (_e1027 > 0i)))];
let _e1033 = (_e1015 + 2i);
let _e1035 = select(_e1017, _e1033, (_e1033 < _e1017));
let _e1040 = global_4.member[bitcast<u32>(select(0i, _e1035, (_e1035 > 0i)))];
let _e1041 = local;
let _e1045 = (_e1010 + (3i * ((_e993 * _e1041) + _e1001)));
let _e1047 = select(_e1017, _e1045, (_e1045 < _e1017));
let _e1052 = global_4.member[bitcast<u32>(select(0i, _e1047, (_e1047 > 0i)))];
let _e1053 = (_e1045 + 1i);
let _e1055 = select(_e1017, _e1053, (_e1053 < _e1017));
let _e1060 = global_4.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = (_e1045 + 2i);
let _e1063 = select(_e1017, _e1061, (_e1061 < _e1017));
let _e1068 = global_4.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1069 = local;
let _e1073 = (_e1010 + (3i * ((_e1004 * _e1069) + _e978)));
let _e1075 = select(_e1017, _e1073, (_e1073 < _e1017));
let _e1080 = global_4.member[bitcast<u32>(select(0i, _e1075, (_e1075 > 0i)))];
let _e1081 = (_e1073 + 1i);
let _e1083 = select(_e1017, _e1081, (_e1081 < _e1017));
let _e1088 = global_4.member[bitcast<u32>(select(0i, _e1083, (_e1083 > 0i)))];
let _e1089 = (_e1073 + 2i);
let _e1091 = select(_e1017, _e1089, (_e1089 < _e1017));
let _e1096 = global_4.member[bitcast<u32>(select(0i, _e1091, (_e1091 > 0i)))];
let _e1097 = local;
let _e1101 = (_e1010 + (3i * ((_e1004 * _e1097) + _e1001)));
let _e1103 = select(_e1017, _e1101, (_e1101 < _e1017));
let _e1108 = global_4.member[bitcast<u32>(select(0i, _e1103, (_e1103 > 0i)))];
let _e1109 = (_e1101 + 1i);
let _e1111 = select(_e1017, _e1109, (_e1109 < _e1017));
let _e1116 = global_4.member[bitcast<u32>(select(0i, _e1111, (_e1111 > 0i)))];
let _e1117 = (_e1101 + 2i);
let _e1119 = select(_e1017, _e1117, (_e1117 < _e1017));
let _e1124 = global_4.member[bitcast<u32>(select(0i, _e1119, (_e1119 > 0i)))];
let _e1131 = (_e1024 + ((_e1052 - _e1024) * _e995));
let _e1132 = (_e1032 + ((_e1060 - _e1032) * _e995));
let _e1133 = (_e1040 + ((_e1068 - _e1040) * _e995));
phi_2170_ = vec3<f32>(((_e1131 + (((_e1080 + ((_e1108 - _e1080) * _e995)) - _e1131) * _e997)) * _e923), ((_e1132 + (((_e1088 + ((_e1116 - _e1088) * _e995)) - _e1132) * _e997)) * _e923), ((_e1133 + (((_e1096 + ((_e1124 - _e1096) * _e995)) - _e1133) * _e997)) * _e923));
} else {
phi_2170_ = vec3(_e923);
}
let _e1158 = phi_2170_;
phi_2173_ = (_e851 * _e1158);
} else {
phi_2173_ = _e851;
}
let _e1161 = phi_2173_;
let _e1165 = (1f / sqrt(select(0f, _e846, (_e846 > 0f))));
phi_2186_ = type_23(vec3<f32>((_e837 * _e1165), (_e838 * _e1165), (_e839 * _e1165)), _e1161);
}
let _e1172 = phi_2186_;
phi_2193_ = (_e1172.member_1 * ((3.1415927f * _e785) * ((_e802 * _e802) * _e802)));
}
let _e1180 = phi_2193_;
let _e1203 = (((_e536 * _e536) + (_e537 * _e537)) + (_e538 * _e538));
let _e1211 = (((_e542 * _e542) + (_e543 * _e543)) + (_e544 * _e544));
let _e1221 = (((_e514 * _e514) + (_e515 * _e515)) + (_e516 * _e516));
let _e1229 = (((_e530 * _e530) + (_e531 * _e531)) + (_e532 * _e532));
global_3.member[_e86] = (_e109 + (_e141 * _e499));
global_3.member[(_e84 + _e86)] = (_e119 + (_e152 * _e499));
global_3.member[((2u * _e84) + _e86)] = (_e130 + (_e163 * _e499));
global_3.member[((3u * _e84) + _e86)] = _e141;
global_3.member[((4u * _e84) + _e86)] = _e152;
global_3.member[((5u * _e84) + _e86)] = _e163;
global_3.member[((6u * _e84) + _e86)] = _e536;
global_3.member[((7u * _e84) + _e86)] = _e537;
global_3.member[((8u * _e84) + _e86)] = _e538;
global_3.member[((9u * _e84) + _e86)] = _e542;
global_3.member[((10u * _e84) + _e86)] = _e543;
global_3.member[((11u * _e84) + _e86)] = _e544;
global_3.member[((12u * _e84) + _e86)] = _e514;
global_3.member[((13u * _e84) + _e86)] = _e515;
global_3.member[((14u * _e84) + _e86)] = _e516;
global_3.member[((15u * _e84) + _e86)] = _e530;
global_3.member[((16u * _e84) + _e86)] = _e531;
global_3.member[((17u * _e84) + _e86)] = _e532;
global_3.member[((18u * _e84) + _e86)] = select(0f, ((_e1180.x * _e306) * ((1f + (_e668 * (1f + (_e668 * (0.5f + (_e668 * (0.16666667f + (_e668 * (0.041666668f + (_e668 * (0.008333334f + (_e668 * (0.001388889f + (_e668 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e663 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((19u * _e84) + _e86)] = select(0f, ((_e1180.y * _e317) * ((1f + (_e716 * (1f + (_e716 * (0.5f + (_e716 * (0.16666667f + (_e716 * (0.041666668f + (_e716 * (0.008333334f + (_e716 * (0.001388889f + (_e716 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e711 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((20u * _e84) + _e86)] = select(0f, ((_e1180.z * _e328) * ((1f + (_e764 * (1f + (_e764 * (0.5f + (_e764 * (0.16666667f + (_e764 * (0.041666668f + (_e764 * (0.008333334f + (_e764 * (0.001388889f + (_e764 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e759 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((21u * _e84) + _e86)] = (0.5f * (sqrt(select(0f, _e1203, (_e1203 > 0f))) + sqrt(select(0f, _e1211, (_e1211 > 0f)))));
global_3.member[((22u * _e84) + _e86)] = (0.5f * (sqrt(select(0f, _e1221, (_e1221 > 0f))) + sqrt(select(0f, _e1229, (_e1229 > 0f)))));
global_3.member[((23u * _e84) + _e86)] = (select(_e422, _e497, _e498) - _e499);
global_3.member[((24u * _e84) + _e86)] = (_e423 - _e499);
global_3.member[((25u * _e84) + _e86)] = f32(select(_e390, -1i, _e406));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
