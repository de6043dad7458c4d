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
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_4105_: type_29;
var phi_4883_: type_30;
var phi_5884_: type_5;
var phi_6908_: f32;
var phi_6909_: f32;
var phi_6910_: f32;
var phi_6911_: bool;
switch bitcast<i32>(0u) {
default: {
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e100 = global_1.member.member_2;
let _e103 = global_1.member.member;
let _e111 = (_e86.x + _e100.member);
let _e113 = (_e86.y + _e100.member_1);
if (_e111 < _e100.member_2) {
if (_e113 < _e100.member_3) {
let _e116 = (_e103.member * _e103.member_1);
let _e118 = ((_e113 * _e103.member) + _e111);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_6.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_6.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_6.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_6.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_6.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_6.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_6.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_6.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_6.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((9u * _e116) + _e118);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e121, _e219, (_e219 < _e121));
let _e227 = global_6.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((10u * _e116) + _e118);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e121, _e230, (_e230 < _e121));
let _e238 = global_6.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e242 = global_1.member.member_5.member_2;
let _e245 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e249 = global_1.member.member_8.member_5;
let _e250 = (_e242 * _e249);
let _e255 = global_1.member.member_8.member_6;
let _e257 = (((_e172 * _e245) - _e255) * _e250);
let _e262 = global_1.member.member_8.member_7;
let _e264 = (((_e183 * _e245) - _e262) * _e250);
let _e268 = ((f32(bitcast<i32>(_e111)) - 0.5f) + _e129);
let _e272 = global_1.member.member_8.member_1;
let _e273 = (_e272 + 1u);
let _e275 = select(1u, _e273, (_e273 > 0u));
let _e276 = (_e275 == 0u);
if _e276 {
break;
}
let _e281 = ((f32(bitcast<i32>((_e113 % _e275))) - 0.5f) + _e139);
let _e285 = global_1.member.member_5.member;
let _e289 = global_1.member.member_8.member_8;
let _e290 = (_e285 - _e289);
let _e294 = global_1.member.member_8.member_2;
let _e301 = global_1.member.member_8.member_4;
let _e303 = ((_e294 + (_e255 * _e290)) + ((_e268 + 0.5f) * _e301));
let _e307 = global_1.member.member_8.member_3;
let _e312 = ((_e307 + (_e262 * _e290)) + ((_e281 + 0.5f) * _e301));
let _e318 = global_1.member.member_5.member_1;
let _e319 = (_e318 - _e289);
let _e324 = ((_e294 + (_e255 * _e319)) + (((_e268 + _e257) + 0.5f) * _e301));
let _e329 = ((_e307 + (_e262 * _e319)) + (((_e281 + _e264) + 0.5f) * _e301));
if _e276 {
break;
}
let _e332 = bitcast<i32>(((_e113 / _e275) * 3u));
let _e334 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e336 = select(_e334, _e332, (_e332 < _e334));
let _e342 = global_5.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e343 = (_e332 + 1i);
let _e345 = select(_e334, _e343, (_e343 < _e334));
let _e351 = global_5.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e352 = (_e332 + 2i);
let _e354 = select(_e334, _e352, (_e352 < _e334));
let _e360 = global_5.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e363 = (1f / select(1e-6f, _e360, (_e360 > 1e-6f)));
let _e366 = (((_e342 * _e363) - _e255) * _e250);
let _e369 = (((_e351 * _e363) - _e262) * _e250);
let _e381 = global_1.member.member_6.member;
let _e392 = ((((_e381.member.member * _e303) + (_e381.member.member_1 * _e312)) + (_e381.member.member_2 * _e285)) + _e381.member_1);
let _e396 = global_1.member.member_6.member_1;
let _e407 = ((((_e396.member.member * _e303) + (_e396.member.member_1 * _e312)) + (_e396.member.member_2 * _e285)) + _e396.member_1);
let _e411 = global_1.member.member_6.member_2;
let _e422 = ((((_e411.member.member * _e303) + (_e411.member.member_1 * _e312)) + (_e411.member.member_2 * _e285)) + _e411.member_1);
let _e428 = ((((_e381.member.member * _e324) + (_e381.member.member_1 * _e329)) + (_e381.member.member_2 * _e318)) + _e381.member_1);
let _e434 = ((((_e396.member.member * _e324) + (_e396.member.member_1 * _e329)) + (_e396.member.member_2 * _e318)) + _e396.member_1);
let _e440 = ((((_e411.member.member * _e324) + (_e411.member.member_1 * _e329)) + (_e411.member.member_2 * _e318)) + _e411.member_1);
let _e444 = global_1.member.member_6.member_4;
let _e449 = global_1.member.member_6.member_3.member;
let _e450 = (_e449 - 0.5f);
let _e452 = select(-0.5f, _e428, (_e428 > -0.5f));
let _e454 = select(_e450, _e452, (_e452 < _e450));
let _e459 = global_1.member.member_6.member_3.member_1;
let _e460 = (_e459 - 0.5f);
let _e462 = select(-0.5f, _e434, (_e434 > -0.5f));
let _e464 = select(_e460, _e462, (_e462 < _e460));
let _e469 = global_1.member.member_6.member_3.member_2;
let _e470 = (_e469 - 0.5f);
let _e472 = select(-0.5f, _e440, (_e440 > -0.5f));
let _e474 = select(_e470, _e472, (_e472 < _e470));
let _e475 = (_e428 - _e392);
let _e476 = (_e434 - _e407);
let _e477 = (_e440 - _e422);
let _e480 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
let _e483 = bitcast<f32>((bitcast<u32>(_e476) & 2147483647u));
let _e485 = select(_e483, _e480, (_e480 > _e483));
let _e488 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
let _e497 = bitcast<f32>((bitcast<u32>((_e428 - _e454)) & 2147483647u));
let _e500 = bitcast<f32>((bitcast<u32>((_e434 - _e464)) & 2147483647u));
let _e502 = select(_e500, _e497, (_e497 > _e500));
let _e505 = bitcast<f32>((bitcast<u32>((_e440 - _e474)) & 2147483647u));
let _e509 = (_e454 + 0.5f);
let _e510 = (_e449 - 1f);
let _e512 = select(0f, _e509, (_e509 > 0f));
let _e514 = select(_e510, _e512, (_e512 < _e510));
let _e521 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e529 = global_1.member.member_6.member_12;
let _e530 = (_e529 & 31u);
let _e533 = (_e464 + 0.5f);
let _e534 = (_e459 - 1f);
let _e536 = select(0f, _e533, (_e533 > 0f));
let _e538 = select(_e534, _e536, (_e536 < _e534));
let _e545 = select(0i, select(select(i32(_e538), i32(-2147483648), (_e538 < -2147483600f)), 2147483647i, (_e538 > 2147483500f)), (_e538 == _e538));
let _e552 = (_e474 + 0.5f);
let _e553 = (_e469 - 1f);
let _e555 = select(0f, _e552, (_e552 > 0f));
let _e557 = select(_e553, _e555, (_e555 < _e553));
let _e564 = select(0i, select(select(i32(_e557), i32(-2147483648), (_e557 < -2147483600f)), 2147483647i, (_e557 > 2147483500f)), (_e557 == _e557));
let _e575 = global_1.member.member_6.member_9.member;
let _e581 = global_1.member.member_6.member_9.member_1;
let _e586 = global_1.member.member_6.member_10;
let _e592 = ((bitcast<i32>(_e586) + ((_e521 - select(0i, 1i, (_e514 < f32(_e521)))) >> bitcast<u32>(_e530))) + (bitcast<i32>(_e575) * (((_e545 - select(0i, 1i, (_e538 < f32(_e545)))) >> bitcast<u32>(_e530)) + (bitcast<i32>(_e581) * ((_e564 - select(0i, 1i, (_e557 < f32(_e564)))) >> bitcast<u32>(_e530))))));
let _e594 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e596 = select(_e594, _e592, (_e592 < _e594));
let _e602 = global_3.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e608 = global_1.member.member_1;
let _e615 = (((_e608 & 64u) != 0u) || ((((select(_e488, _e485, (_e485 > _e488)) <= _e444) && ((select(_e505, _e502, (_e502 > _e505)) > _e444) || (_e602 != 0u))) && true) && ((_e608 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e257 == 0f) && (_e264 == 0f)) && (_e366 == 0f)) && (_e369 == 0f))), _e615), (_e238 == 0f)) > 1u) {
if _e276 {
break;
}
if _e276 {
break;
}
let _e622 = (_e103.member_2 == 2u);
let _e625 = (((_e103.member_2 == 1u) || _e622) || (_e103.member_2 == 5u));
if _e625 {
let _e627 = select(-1f, _e454, (_e454 > -1f));
let _e629 = select(_e449, _e627, (_e627 < _e449));
let _e636 = select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < -2147483600f)), 2147483647i, (_e629 > 2147483500f)), (_e629 == _e629));
let _e640 = (_e636 - select(0i, 1i, (_e629 < f32(_e636))));
let _e642 = select(-1f, _e464, (_e464 > -1f));
let _e644 = select(_e459, _e642, (_e642 < _e459));
let _e651 = select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < -2147483600f)), 2147483647i, (_e644 > 2147483500f)), (_e644 == _e644));
let _e655 = (_e651 - select(0i, 1i, (_e644 < f32(_e651))));
let _e657 = select(-1f, _e474, (_e474 > -1f));
let _e659 = select(_e469, _e657, (_e657 < _e469));
let _e666 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < -2147483600f)), 2147483647i, (_e659 > 2147483500f)), (_e659 == _e659));
let _e670 = (_e666 - select(0i, 1i, (_e659 < f32(_e666))));
let _e674 = global_1.member.member_6.member_7;
let _e678 = global_1.member.member_6.member_8;
let _e686 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e687 = (_e655 - 1i);
let _e692 = (_e655 + 1i);
let _e695 = (_e655 + 2i);
let _e705 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e706 = (_e670 - 1i);
let _e711 = (_e670 + 1i);
let _e714 = (_e670 + 2i);
let _e723 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449));
let _e724 = (_e723 - 1i);
let _e725 = (_e640 - 1i);
let _e727 = select(0i, _e725, (_e725 > 0i));
let _e729 = select(0i, _e640, (_e640 > 0i));
let _e730 = (_e640 + 1i);
let _e732 = select(_e724, _e730, (_e730 < _e724));
let _e733 = (_e640 + 2i);
let _e736 = (_e723 - 2i);
let _e738 = select(0i, _e736, (_e736 > 0i));
let _e740 = select(_e738, _e727, (_e727 < _e738));
let _e742 = select(_e738, _e729, (_e729 < _e738));
let _e744 = select(_e738, _e732, (_e732 < _e738));
let _e763 = (select(0i, _e687, (_e687 > 0i)) * _e674);
let _e764 = (select(0i, _e655, (_e655 > 0i)) * _e674);
let _e765 = (select(_e686, _e692, (_e692 < _e686)) * _e674);
let _e766 = (select(_e686, _e695, (_e695 < _e686)) * _e674);
let _e767 = (select(0i, _e706, (_e706 > 0i)) * _e678);
let _e768 = (select(0i, _e670, (_e670 > 0i)) * _e678);
let _e769 = (select(_e705, _e711, (_e711 < _e705)) * _e678);
let _e770 = (select(_e705, _e714, (_e714 < _e705)) * _e678);
local_4 = type_28(array<i32, 4>(_e740, _e742, _e744, 0i), array<u32, 6>(bitcast<u32>(((_e727 - _e740) * 16i)), bitcast<u32>(((_e729 - _e740) * 16i)), bitcast<u32>(((_e729 - _e742) * 16i)), bitcast<u32>(((_e732 - _e742) * 16i)), bitcast<u32>(((_e732 - _e744) * 16i)), bitcast<u32>(((select(_e724, _e733, (_e733 < _e724)) - _e744) * 16i))));
local_5 = vec3<f32>((_e454 - f32(_e640)), (_e464 - f32(_e655)), (_e474 - f32(_e670)));
let _e782 = (_e768 + _e764);
let _e785 = local_4.member[0u];
let _e786 = (_e782 + _e785);
let _e788 = (_e786 >> bitcast<u32>(1i));
let _e791 = bitcast<u32>(((_e786 & 1i) * 16i));
let _e793 = (bitcast<i32>(_e89) - 1i);
let _e795 = select(_e793, _e788, (_e788 < _e793));
let _e800 = global_2.member[bitcast<u32>(select(0i, _e795, (_e795 > 0i)))];
let _e804 = (_e788 + 1i);
let _e806 = select(_e793, _e804, (_e804 < _e793));
let _e811 = global_2.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
let _e818 = ((_e800 >> bitcast<u32>((_e791 & 31u))) | ((_e811 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e791) & 31u))));
let _e821 = local_4.member[2u];
let _e822 = (_e782 + _e821);
let _e824 = (_e822 >> bitcast<u32>(1i));
let _e827 = bitcast<u32>(((_e822 & 1i) * 16i));
let _e829 = select(_e793, _e824, (_e824 < _e793));
let _e834 = global_2.member[bitcast<u32>(select(0i, _e829, (_e829 > 0i)))];
let _e838 = (_e824 + 1i);
let _e840 = select(_e793, _e838, (_e838 < _e793));
let _e845 = global_2.member[bitcast<u32>(select(0i, _e840, (_e840 > 0i)))];
let _e852 = ((_e834 >> bitcast<u32>((_e827 & 31u))) | ((_e845 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e827) & 31u))));
let _e855 = local_4.member_1[0u];
let _e861 = f32(bitcast<i32>(((_e818 >> bitcast<u32>((_e855 & 31u))) & 65535u)));
let _e864 = local_4.member_1[1u];
let _e870 = f32(bitcast<i32>(((_e818 >> bitcast<u32>((_e864 & 31u))) & 65535u)));
let _e873 = local_4.member_1[4u];
let _e879 = f32(bitcast<i32>(((_e852 >> bitcast<u32>((_e873 & 31u))) & 65535u)));
let _e882 = local_4.member_1[5u];
let _e889 = local_5[0u];
let _e892 = (_e861 + ((_e870 - _e861) * _e889));
let _e893 = local_5[0u];
let _e896 = (_e870 + ((_e879 - _e870) * _e893));
let _e897 = local_5[0u];
let _e900 = (_e879 + ((f32(bitcast<i32>(((_e852 >> bitcast<u32>((_e882 & 31u))) & 65535u))) - _e879) * _e897));
let _e901 = (_e768 + _e765);
let _e902 = local_4.member[0u];
let _e903 = (_e901 + _e902);
let _e905 = (_e903 >> bitcast<u32>(1i));
let _e908 = bitcast<u32>(((_e903 & 1i) * 16i));
let _e910 = select(_e793, _e905, (_e905 < _e793));
let _e915 = global_2.member[bitcast<u32>(select(0i, _e910, (_e910 > 0i)))];
let _e919 = (_e905 + 1i);
let _e921 = select(_e793, _e919, (_e919 < _e793));
let _e926 = global_2.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e933 = ((_e915 >> bitcast<u32>((_e908 & 31u))) | ((_e926 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e908) & 31u))));
let _e934 = local_4.member[2u];
let _e935 = (_e901 + _e934);
let _e937 = (_e935 >> bitcast<u32>(1i));
let _e940 = bitcast<u32>(((_e935 & 1i) * 16i));
let _e942 = select(_e793, _e937, (_e937 < _e793));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
let _e951 = (_e937 + 1i);
let _e953 = select(_e793, _e951, (_e951 < _e793));
let _e958 = global_2.member[bitcast<u32>(select(0i, _e953, (_e953 > 0i)))];
let _e965 = ((_e947 >> bitcast<u32>((_e940 & 31u))) | ((_e958 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e940) & 31u))));
let _e966 = local_4.member_1[0u];
let _e972 = f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e966 & 31u))) & 65535u)));
let _e973 = local_4.member_1[1u];
let _e979 = f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e973 & 31u))) & 65535u)));
let _e980 = local_4.member_1[4u];
let _e986 = f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e980 & 31u))) & 65535u)));
let _e987 = local_4.member_1[5u];
let _e994 = local_5[0u];
let _e998 = local_5[0u];
let _e1001 = (_e979 + ((_e986 - _e979) * _e998));
let _e1002 = local_5[0u];
let _e1006 = (_e769 + _e764);
let _e1007 = local_4.member[0u];
let _e1008 = (_e1006 + _e1007);
let _e1010 = (_e1008 >> bitcast<u32>(1i));
let _e1013 = bitcast<u32>(((_e1008 & 1i) * 16i));
let _e1015 = select(_e793, _e1010, (_e1010 < _e793));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1024 = (_e1010 + 1i);
let _e1026 = select(_e793, _e1024, (_e1024 < _e793));
let _e1031 = global_2.member[bitcast<u32>(select(0i, _e1026, (_e1026 > 0i)))];
let _e1038 = ((_e1020 >> bitcast<u32>((_e1013 & 31u))) | ((_e1031 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1013) & 31u))));
let _e1039 = local_4.member[2u];
let _e1040 = (_e1006 + _e1039);
let _e1042 = (_e1040 >> bitcast<u32>(1i));
let _e1045 = bitcast<u32>(((_e1040 & 1i) * 16i));
let _e1047 = select(_e793, _e1042, (_e1042 < _e793));
let _e1052 = global_2.member[bitcast<u32>(select(0i, _e1047, (_e1047 > 0i)))];
let _e1056 = (_e1042 + 1i);
let _e1058 = select(_e793, _e1056, (_e1056 < _e793));
let _e1063 = global_2.member[bitcast<u32>(select(0i, _e1058, (_e1058 > 0i)))];
let _e1070 = ((_e1052 >> bitcast<u32>((_e1045 & 31u))) | ((_e1063 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1045) & 31u))));
let _e1071 = local_4.member_1[0u];
let _e1077 = f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1071 & 31u))) & 65535u)));
let _e1078 = local_4.member_1[1u];
let _e1084 = f32(bitcast<i32>(((_e1038 >> bitcast<u32>((_e1078 & 31u))) & 65535u)));
let _e1085 = local_4.member_1[4u];
let _e1091 = f32(bitcast<i32>(((_e1070 >> bitcast<u32>((_e1085 & 31u))) & 65535u)));
let _e1092 = local_4.member_1[5u];
let _e1099 = local_5[0u];
let _e1102 = (_e1077 + ((_e1084 - _e1077) * _e1099));
let _e1103 = local_5[0u];
let _e1106 = (_e1084 + ((_e1091 - _e1084) * _e1103));
let _e1107 = local_5[0u];
let _e1110 = (_e1091 + ((f32(bitcast<i32>(((_e1070 >> bitcast<u32>((_e1092 & 31u))) & 65535u))) - _e1091) * _e1107));
let _e1111 = (_e769 + _e765);
let _e1112 = local_4.member[0u];
let _e1113 = (_e1111 + _e1112);
let _e1115 = (_e1113 >> bitcast<u32>(1i));
let _e1118 = bitcast<u32>(((_e1113 & 1i) * 16i));
let _e1120 = select(_e793, _e1115, (_e1115 < _e793));
let _e1125 = global_2.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1129 = (_e1115 + 1i);
let _e1131 = select(_e793, _e1129, (_e1129 < _e793));
let _e1136 = global_2.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1143 = ((_e1125 >> bitcast<u32>((_e1118 & 31u))) | ((_e1136 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1118) & 31u))));
let _e1144 = local_4.member[2u];
let _e1145 = (_e1111 + _e1144);
let _e1147 = (_e1145 >> bitcast<u32>(1i));
let _e1150 = bitcast<u32>(((_e1145 & 1i) * 16i));
let _e1152 = select(_e793, _e1147, (_e1147 < _e793));
let _e1157 = global_2.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1161 = (_e1147 + 1i);
let _e1163 = select(_e793, _e1161, (_e1161 < _e793));
let _e1168 = global_2.member[bitcast<u32>(select(0i, _e1163, (_e1163 > 0i)))];
let _e1175 = ((_e1157 >> bitcast<u32>((_e1150 & 31u))) | ((_e1168 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1150) & 31u))));
let _e1176 = local_4.member_1[0u];
let _e1182 = f32(bitcast<i32>(((_e1143 >> bitcast<u32>((_e1176 & 31u))) & 65535u)));
let _e1183 = local_4.member_1[1u];
let _e1189 = f32(bitcast<i32>(((_e1143 >> bitcast<u32>((_e1183 & 31u))) & 65535u)));
let _e1190 = local_4.member_1[4u];
let _e1196 = f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1190 & 31u))) & 65535u)));
let _e1197 = local_4.member_1[5u];
let _e1204 = local_5[0u];
let _e1208 = local_5[0u];
let _e1211 = (_e1189 + ((_e1196 - _e1189) * _e1208));
let _e1212 = local_5[0u];
let _e1219 = local_4.member[1u];
let _e1220 = ((_e768 + _e763) + _e1219);
let _e1222 = (_e1220 >> bitcast<u32>(1i));
let _e1225 = bitcast<u32>(((_e1220 & 1i) * 16i));
let _e1227 = select(_e793, _e1222, (_e1222 < _e793));
let _e1232 = global_2.member[bitcast<u32>(select(0i, _e1227, (_e1227 > 0i)))];
let _e1236 = (_e1222 + 1i);
let _e1238 = select(_e793, _e1236, (_e1236 < _e793));
let _e1243 = global_2.member[bitcast<u32>(select(0i, _e1238, (_e1238 > 0i)))];
let _e1250 = ((_e1232 >> bitcast<u32>((_e1225 & 31u))) | ((_e1243 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1225) & 31u))));
let _e1253 = local_4.member_1[2u];
let _e1259 = f32(bitcast<i32>(((_e1250 >> bitcast<u32>((_e1253 & 31u))) & 65535u)));
let _e1262 = local_4.member_1[3u];
let _e1269 = local_5[0u];
let _e1272 = (_e1259 + ((f32(bitcast<i32>(((_e1250 >> bitcast<u32>((_e1262 & 31u))) & 65535u))) - _e1259) * _e1269));
let _e1274 = local_4.member[1u];
let _e1275 = ((_e768 + _e766) + _e1274);
let _e1277 = (_e1275 >> bitcast<u32>(1i));
let _e1280 = bitcast<u32>(((_e1275 & 1i) * 16i));
let _e1282 = select(_e793, _e1277, (_e1277 < _e793));
let _e1287 = global_2.member[bitcast<u32>(select(0i, _e1282, (_e1282 > 0i)))];
let _e1291 = (_e1277 + 1i);
let _e1293 = select(_e793, _e1291, (_e1291 < _e793));
let _e1298 = global_2.member[bitcast<u32>(select(0i, _e1293, (_e1293 > 0i)))];
let _e1305 = ((_e1287 >> bitcast<u32>((_e1280 & 31u))) | ((_e1298 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1280) & 31u))));
let _e1306 = local_4.member_1[2u];
let _e1312 = f32(bitcast<i32>(((_e1305 >> bitcast<u32>((_e1306 & 31u))) & 65535u)));
let _e1313 = local_4.member_1[3u];
let _e1320 = local_5[0u];
let _e1325 = local_4.member[1u];
let _e1326 = ((_e769 + _e763) + _e1325);
let _e1328 = (_e1326 >> bitcast<u32>(1i));
let _e1331 = bitcast<u32>(((_e1326 & 1i) * 16i));
let _e1333 = select(_e793, _e1328, (_e1328 < _e793));
let _e1338 = global_2.member[bitcast<u32>(select(0i, _e1333, (_e1333 > 0i)))];
let _e1342 = (_e1328 + 1i);
let _e1344 = select(_e793, _e1342, (_e1342 < _e793));
let _e1349 = global_2.member[bitcast<u32>(select(0i, _e1344, (_e1344 > 0i)))];
let _e1356 = ((_e1338 >> bitcast<u32>((_e1331 & 31u))) | ((_e1349 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1331) & 31u))));
let _e1357 = local_4.member_1[2u];
let _e1363 = f32(bitcast<i32>(((_e1356 >> bitcast<u32>((_e1357 & 31u))) & 65535u)));
let _e1364 = local_4.member_1[3u];
let _e1371 = local_5[0u];
let _e1374 = (_e1363 + ((f32(bitcast<i32>(((_e1356 >> bitcast<u32>((_e1364 & 31u))) & 65535u))) - _e1363) * _e1371));
let _e1376 = local_4.member[1u];
let _e1377 = ((_e769 + _e766) + _e1376);
let _e1379 = (_e1377 >> bitcast<u32>(1i));
let _e1382 = bitcast<u32>(((_e1377 & 1i) * 16i));
let _e1384 = select(_e793, _e1379, (_e1379 < _e793));
let _e1389 = global_2.member[bitcast<u32>(select(0i, _e1384, (_e1384 > 0i)))];
let _e1393 = (_e1379 + 1i);
let _e1395 = select(_e793, _e1393, (_e1393 < _e793));
let _e1400 = global_2.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1407 = ((_e1389 >> bitcast<u32>((_e1382 & 31u))) | ((_e1400 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1382) & 31u))));
let _e1408 = local_4.member_1[2u];
let _e1414 = f32(bitcast<i32>(((_e1407 >> bitcast<u32>((_e1408 & 31u))) & 65535u)));
let _e1415 = local_4.member_1[3u];
let _e1422 = local_5[0u];
let _e1427 = local_4.member[1u];
let _e1428 = ((_e767 + _e764) + _e1427);
let _e1430 = (_e1428 >> bitcast<u32>(1i));
let _e1433 = bitcast<u32>(((_e1428 & 1i) * 16i));
let _e1435 = select(_e793, _e1430, (_e1430 < _e793));
let _e1440 = global_2.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1444 = (_e1430 + 1i);
let _e1446 = select(_e793, _e1444, (_e1444 < _e793));
let _e1451 = global_2.member[bitcast<u32>(select(0i, _e1446, (_e1446 > 0i)))];
let _e1458 = ((_e1440 >> bitcast<u32>((_e1433 & 31u))) | ((_e1451 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1433) & 31u))));
let _e1459 = local_4.member_1[2u];
let _e1465 = f32(bitcast<i32>(((_e1458 >> bitcast<u32>((_e1459 & 31u))) & 65535u)));
let _e1466 = local_4.member_1[3u];
let _e1473 = local_5[0u];
let _e1476 = (_e1465 + ((f32(bitcast<i32>(((_e1458 >> bitcast<u32>((_e1466 & 31u))) & 65535u))) - _e1465) * _e1473));
let _e1478 = local_4.member[1u];
let _e1479 = ((_e770 + _e764) + _e1478);
let _e1481 = (_e1479 >> bitcast<u32>(1i));
let _e1484 = bitcast<u32>(((_e1479 & 1i) * 16i));
let _e1486 = select(_e793, _e1481, (_e1481 < _e793));
let _e1491 = global_2.member[bitcast<u32>(select(0i, _e1486, (_e1486 > 0i)))];
let _e1495 = (_e1481 + 1i);
let _e1497 = select(_e793, _e1495, (_e1495 < _e793));
let _e1502 = global_2.member[bitcast<u32>(select(0i, _e1497, (_e1497 > 0i)))];
let _e1509 = ((_e1491 >> bitcast<u32>((_e1484 & 31u))) | ((_e1502 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1484) & 31u))));
let _e1510 = local_4.member_1[2u];
let _e1516 = f32(bitcast<i32>(((_e1509 >> bitcast<u32>((_e1510 & 31u))) & 65535u)));
let _e1517 = local_4.member_1[3u];
let _e1524 = local_5[0u];
let _e1527 = (_e1516 + ((f32(bitcast<i32>(((_e1509 >> bitcast<u32>((_e1517 & 31u))) & 65535u))) - _e1516) * _e1524));
let _e1529 = local_4.member[1u];
let _e1530 = ((_e767 + _e765) + _e1529);
let _e1532 = (_e1530 >> bitcast<u32>(1i));
let _e1535 = bitcast<u32>(((_e1530 & 1i) * 16i));
let _e1537 = select(_e793, _e1532, (_e1532 < _e793));
let _e1542 = global_2.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1546 = (_e1532 + 1i);
let _e1548 = select(_e793, _e1546, (_e1546 < _e793));
let _e1553 = global_2.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1560 = ((_e1542 >> bitcast<u32>((_e1535 & 31u))) | ((_e1553 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1535) & 31u))));
let _e1561 = local_4.member_1[2u];
let _e1567 = f32(bitcast<i32>(((_e1560 >> bitcast<u32>((_e1561 & 31u))) & 65535u)));
let _e1568 = local_4.member_1[3u];
let _e1575 = local_5[0u];
let _e1580 = local_4.member[1u];
let _e1581 = ((_e770 + _e765) + _e1580);
let _e1583 = (_e1581 >> bitcast<u32>(1i));
let _e1586 = bitcast<u32>(((_e1581 & 1i) * 16i));
let _e1588 = select(_e793, _e1583, (_e1583 < _e793));
let _e1593 = global_2.member[bitcast<u32>(select(0i, _e1588, (_e1588 > 0i)))];
let _e1597 = (_e1583 + 1i);
let _e1599 = select(_e793, _e1597, (_e1597 < _e793));
let _e1604 = global_2.member[bitcast<u32>(select(0i, _e1599, (_e1599 > 0i)))];
let _e1611 = ((_e1593 >> bitcast<u32>((_e1586 & 31u))) | ((_e1604 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1586) & 31u))));
let _e1612 = local_4.member_1[2u];
let _e1618 = f32(bitcast<i32>(((_e1611 >> bitcast<u32>((_e1612 & 31u))) & 65535u)));
let _e1619 = local_4.member_1[3u];
let _e1626 = local_5[0u];
let _e1631 = local_5[1u];
let _e1634 = (_e896 + ((_e1001 - _e896) * _e1631));
let _e1635 = local_5[1u];
let _e1638 = (_e1106 + ((_e1211 - _e1106) * _e1635));
let _e1639 = local_5[1u];
let _e1642 = (_e892 + (((_e972 + ((_e979 - _e972) * _e994)) - _e892) * _e1639));
let _e1643 = local_5[1u];
let _e1648 = local_5[2u];
let _e1652 = local_5[1u];
let _e1655 = (_e900 + (((_e986 + ((f32(bitcast<i32>(((_e965 >> bitcast<u32>((_e987 & 31u))) & 65535u))) - _e986) * _e1002)) - _e900) * _e1652));
let _e1656 = local_5[1u];
let _e1660 = local_5[2u];
let _e1664 = local_5[1u];
let _e1667 = (_e1272 + ((_e896 - _e1272) * _e1664));
let _e1668 = local_5[1u];
let _e1672 = local_5[2u];
let _e1676 = local_5[1u];
let _e1679 = (_e1001 + (((_e1312 + ((f32(bitcast<i32>(((_e1305 >> bitcast<u32>((_e1313 & 31u))) & 65535u))) - _e1312) * _e1320)) - _e1001) * _e1676));
let _e1680 = local_5[1u];
let _e1684 = local_5[2u];
let _e1688 = local_5[1u];
let _e1691 = (_e1476 + (((_e1567 + ((f32(bitcast<i32>(((_e1560 >> bitcast<u32>((_e1568 & 31u))) & 65535u))) - _e1567) * _e1575)) - _e1476) * _e1688));
let _e1692 = local_5[2u];
let _e1696 = local_5[1u];
let _e1700 = local_5[2u];
let _e1704 = local_5[2u];
let _e1711 = global_1.member.member_6.member_5;
let _e1716 = global_1.member.member_6.member_6;
let _e1717 = (((_e1634 + ((_e1638 - _e1634) * _e1704)) * _e1711) + _e1716);
let _e1719 = select(0f, _e1717, (_e1717 > 0f));
let _e1721 = select(1f, _e1719, (_e1719 < 1f));
let _e1723 = (((_e1642 + (((_e1102 + (((_e1182 + ((_e1189 - _e1182) * _e1204)) - _e1102) * _e1643)) - _e1642) * _e1648)) * _e1711) + _e1716);
let _e1725 = select(0f, _e1723, (_e1723 > 0f));
let _e1727 = select(1f, _e1725, (_e1725 < 1f));
let _e1729 = (((_e1655 + (((_e1110 + (((_e1196 + ((f32(bitcast<i32>(((_e1175 >> bitcast<u32>((_e1197 & 31u))) & 65535u))) - _e1196) * _e1212)) - _e1110) * _e1656)) - _e1655) * _e1660)) * _e1711) + _e1716);
let _e1731 = select(0f, _e1729, (_e1729 > 0f));
let _e1733 = select(1f, _e1731, (_e1731 < 1f));
let _e1735 = (((_e1667 + (((_e1374 + ((_e1106 - _e1374) * _e1668)) - _e1667) * _e1672)) * _e1711) + _e1716);
let _e1737 = select(0f, _e1735, (_e1735 > 0f));
let _e1739 = select(1f, _e1737, (_e1737 < 1f));
let _e1741 = (((_e1679 + (((_e1211 + (((_e1414 + ((f32(bitcast<i32>(((_e1407 >> bitcast<u32>((_e1415 & 31u))) & 65535u))) - _e1414) * _e1422)) - _e1211) * _e1680)) - _e1679) * _e1684)) * _e1711) + _e1716);
let _e1743 = select(0f, _e1741, (_e1741 > 0f));
let _e1745 = select(1f, _e1743, (_e1743 < 1f));
let _e1747 = (((_e1691 + ((_e1634 - _e1691) * _e1692)) * _e1711) + _e1716);
let _e1749 = select(0f, _e1747, (_e1747 > 0f));
let _e1751 = select(1f, _e1749, (_e1749 < 1f));
let _e1753 = (((_e1638 + (((_e1527 + (((_e1618 + ((f32(bitcast<i32>(((_e1611 >> bitcast<u32>((_e1619 & 31u))) & 65535u))) - _e1618) * _e1626)) - _e1527) * _e1696)) - _e1638) * _e1700)) * _e1711) + _e1716);
let _e1755 = select(0f, _e1753, (_e1753 > 0f));
let _e1757 = select(1f, _e1755, (_e1755 < 1f));
let _e1758 = (_e1721 * 1024f);
let _e1759 = (1024f - 1f);
let _e1761 = select(0f, _e1758, (_e1758 > 0f));
let _e1763 = select(_e1759, _e1761, (_e1761 < _e1759));
let _e1770 = select(0i, select(select(i32(_e1763), i32(-2147483648), (_e1763 < -2147483600f)), 2147483647i, (_e1763 > 2147483500f)), (_e1763 == _e1763));
let _e1774 = (_e1770 - select(0i, 1i, (_e1763 < f32(_e1770))));
let _e1775 = (262147i + _e1774);
let _e1777 = (bitcast<i32>(_e93) - 1i);
let _e1779 = select(_e1777, _e1775, (_e1775 < _e1777));
let _e1785 = global_4.member[bitcast<u32>(select(0i, _e1779, (_e1779 > 0i)))];
let _e1795 = select(_e1777, 262146i, (262146i < _e1777));
let _e1801 = global_4.member[bitcast<u32>(select(0i, _e1795, (_e1795 > 0i)))];
let _e1802 = bitcast<f32>(_e1801);
let _e1803 = (f32((bitcast<i32>((_e1785 & 4095u)) - 2048i)) * _e1802);
let _e1805 = select(_e1777, 262144i, (262144i < _e1777));
let _e1811 = global_4.member[bitcast<u32>(select(0i, _e1805, (_e1805 > 0i)))];
let _e1812 = bitcast<f32>(_e1811);
let _e1814 = select(_e1777, 262145i, (262145i < _e1777));
let _e1820 = global_4.member[bitcast<u32>(select(0i, _e1814, (_e1814 > 0i)))];
let _e1821 = bitcast<f32>(_e1820);
let _e1827 = ((_e1812 + (f32(bitcast<i32>((_e1785 >> bitcast<u32>(12u)))) * _e1821)) + (_e1803 * (_e1758 - f32(_e1774))));
let _e1828 = (_e1803 * 1024f);
if _e622 {
let _e1835 = ((0.5f * (_e1733 - _e1727)) * _e1828);
let _e1836 = ((0.5f * (_e1745 - _e1739)) * _e1828);
let _e1837 = ((0.5f * (_e1757 - _e1751)) * _e1828);
phi_4105_ = type_29(_e1827, vec3<f32>(_e1835, _e1836, _e1837), vec3<f32>((_e1835 * _e1827), (_e1836 * _e1827), (_e1837 * _e1827)));
} else {
let _e1844 = (_e1727 * 1024f);
let _e1846 = select(0f, _e1844, (_e1844 > 0f));
let _e1848 = select(_e1759, _e1846, (_e1846 < _e1759));
let _e1855 = select(0i, select(select(i32(_e1848), i32(-2147483648), (_e1848 < -2147483600f)), 2147483647i, (_e1848 > 2147483500f)), (_e1848 == _e1848));
let _e1859 = (_e1855 - select(0i, 1i, (_e1848 < f32(_e1855))));
let _e1860 = (262147i + _e1859);
let _e1862 = select(_e1777, _e1860, (_e1860 < _e1777));
let _e1868 = global_4.member[bitcast<u32>(select(0i, _e1862, (_e1862 > 0i)))];
let _e1883 = ((_e1812 + (f32(bitcast<i32>((_e1868 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e1868 & 4095u)) - 2048i)) * _e1802) * (_e1844 - f32(_e1859))));
let _e1884 = (_e1733 * 1024f);
let _e1886 = select(0f, _e1884, (_e1884 > 0f));
let _e1888 = select(_e1759, _e1886, (_e1886 < _e1759));
let _e1895 = select(0i, select(select(i32(_e1888), i32(-2147483648), (_e1888 < -2147483600f)), 2147483647i, (_e1888 > 2147483500f)), (_e1888 == _e1888));
let _e1899 = (_e1895 - select(0i, 1i, (_e1888 < f32(_e1895))));
let _e1900 = (262147i + _e1899);
let _e1902 = select(_e1777, _e1900, (_e1900 < _e1777));
let _e1908 = global_4.member[bitcast<u32>(select(0i, _e1902, (_e1902 > 0i)))];
let _e1923 = ((_e1812 + (f32(bitcast<i32>((_e1908 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e1908 & 4095u)) - 2048i)) * _e1802) * (_e1884 - f32(_e1899))));
let _e1924 = (_e1739 * 1024f);
let _e1926 = select(0f, _e1924, (_e1924 > 0f));
let _e1928 = select(_e1759, _e1926, (_e1926 < _e1759));
let _e1935 = select(0i, select(select(i32(_e1928), i32(-2147483648), (_e1928 < -2147483600f)), 2147483647i, (_e1928 > 2147483500f)), (_e1928 == _e1928));
let _e1939 = (_e1935 - select(0i, 1i, (_e1928 < f32(_e1935))));
let _e1940 = (262147i + _e1939);
let _e1942 = select(_e1777, _e1940, (_e1940 < _e1777));
let _e1948 = global_4.member[bitcast<u32>(select(0i, _e1942, (_e1942 > 0i)))];
let _e1963 = ((_e1812 + (f32(bitcast<i32>((_e1948 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e1948 & 4095u)) - 2048i)) * _e1802) * (_e1924 - f32(_e1939))));
let _e1964 = (_e1745 * 1024f);
let _e1966 = select(0f, _e1964, (_e1964 > 0f));
let _e1968 = select(_e1759, _e1966, (_e1966 < _e1759));
let _e1975 = select(0i, select(select(i32(_e1968), i32(-2147483648), (_e1968 < -2147483600f)), 2147483647i, (_e1968 > 2147483500f)), (_e1968 == _e1968));
let _e1979 = (_e1975 - select(0i, 1i, (_e1968 < f32(_e1975))));
let _e1980 = (262147i + _e1979);
let _e1982 = select(_e1777, _e1980, (_e1980 < _e1777));
let _e1988 = global_4.member[bitcast<u32>(select(0i, _e1982, (_e1982 > 0i)))];
let _e2003 = ((_e1812 + (f32(bitcast<i32>((_e1988 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e1988 & 4095u)) - 2048i)) * _e1802) * (_e1964 - f32(_e1979))));
let _e2004 = (_e1751 * 1024f);
let _e2006 = select(0f, _e2004, (_e2004 > 0f));
let _e2008 = select(_e1759, _e2006, (_e2006 < _e1759));
let _e2015 = select(0i, select(select(i32(_e2008), i32(-2147483648), (_e2008 < -2147483600f)), 2147483647i, (_e2008 > 2147483500f)), (_e2008 == _e2008));
let _e2019 = (_e2015 - select(0i, 1i, (_e2008 < f32(_e2015))));
let _e2020 = (262147i + _e2019);
let _e2022 = select(_e1777, _e2020, (_e2020 < _e1777));
let _e2028 = global_4.member[bitcast<u32>(select(0i, _e2022, (_e2022 > 0i)))];
let _e2043 = ((_e1812 + (f32(bitcast<i32>((_e2028 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e2028 & 4095u)) - 2048i)) * _e1802) * (_e2004 - f32(_e2019))));
let _e2044 = (_e1757 * 1024f);
let _e2046 = select(0f, _e2044, (_e2044 > 0f));
let _e2048 = select(_e1759, _e2046, (_e2046 < _e1759));
let _e2055 = select(0i, select(select(i32(_e2048), i32(-2147483648), (_e2048 < -2147483600f)), 2147483647i, (_e2048 > 2147483500f)), (_e2048 == _e2048));
let _e2059 = (_e2055 - select(0i, 1i, (_e2048 < f32(_e2055))));
let _e2060 = (262147i + _e2059);
let _e2062 = select(_e1777, _e2060, (_e2060 < _e1777));
let _e2068 = global_4.member[bitcast<u32>(select(0i, _e2062, (_e2062 > 0i)))];
let _e2083 = ((_e1812 + (f32(bitcast<i32>((_e2068 >> bitcast<u32>(12u)))) * _e1821)) + ((f32((bitcast<i32>((_e2068 & 4095u)) - 2048i)) * _e1802) * (_e2044 - f32(_e2059))));
let _e2084 = (_e1923 - _e1883);
let _e2086 = (_e2003 - _e1963);
let _e2088 = (_e2083 - _e2043);
phi_4105_ = type_29(_e1827, vec3<f32>((0.5f * _e2084), (0.5f * _e2086), (0.5f * _e2088)), vec3<f32>((0.25f * (_e2084 * (_e1923 + _e1883))), (0.25f * (_e2086 * (_e2003 + _e1963))), (0.25f * (_e2088 * (_e2083 + _e2043)))));
}
let _e2103 = phi_4105_;
let _e2118 = select(0f, 1f, ((((((_e428 >= -0.5f) && (_e428 <= _e450)) && (_e434 >= -0.5f)) && (_e434 <= _e460)) && (_e440 >= -0.5f)) && (_e440 <= _e470)));
let _e2120 = (0.5f * (_e1733 - _e1727));
let _e2122 = (0.5f * (_e1745 - _e1739));
let _e2124 = (0.5f * (_e1757 - _e1751));
let _e2130 = global_1.member.member_6.member.member.member;
let _e2136 = global_1.member.member_6.member.member.member_1;
let _e2142 = global_1.member.member_6.member.member.member_2;
let _e2148 = global_1.member.member_6.member_1.member.member;
let _e2154 = global_1.member.member_6.member_1.member.member_1;
let _e2160 = global_1.member.member_6.member_1.member.member_2;
let _e2166 = global_1.member.member_6.member_2.member.member;
let _e2172 = global_1.member.member_6.member_2.member.member_1;
let _e2178 = global_1.member.member_6.member_2.member.member_2;
phi_4883_ = type_30(_e1721, vec3<f32>(((((_e2130 * _e2120) + (_e2148 * _e2122)) + (_e2166 * _e2124)) * _e2118), ((((_e2136 * _e2120) + (_e2154 * _e2122)) + (_e2172 * _e2124)) * _e2118), ((((_e2142 * _e2120) + (_e2160 * _e2122)) + (_e2178 * _e2124)) * _e2118)), _e2103.member, vec3<f32>(((((_e2130 * _e2103.member_2.x) + (_e2148 * _e2103.member_2.y)) + (_e2166 * _e2103.member_2.z)) * _e2118), ((((_e2136 * _e2103.member_2.x) + (_e2154 * _e2103.member_2.y)) + (_e2172 * _e2103.member_2.z)) * _e2118), ((((_e2142 * _e2103.member_2.x) + (_e2160 * _e2103.member_2.y)) + (_e2178 * _e2103.member_2.z)) * _e2118)), vec3<f32>(((((_e2130 * _e2103.member_1.x) + (_e2148 * _e2103.member_1.y)) + (_e2166 * _e2103.member_1.z)) * _e2118), ((((_e2136 * _e2103.member_1.x) + (_e2154 * _e2103.member_1.y)) + (_e2172 * _e2103.member_1.z)) * _e2118), ((((_e2142 * _e2103.member_1.x) + (_e2160 * _e2103.member_1.y)) + (_e2178 * _e2103.member_1.z)) * _e2118)));
} else {
let _e2244 = select(-1f, _e454, (_e454 > -1f));
let _e2246 = select(_e449, _e2244, (_e2244 < _e449));
let _e2253 = select(0i, select(select(i32(_e2246), i32(-2147483648), (_e2246 < -2147483600f)), 2147483647i, (_e2246 > 2147483500f)), (_e2246 == _e2246));
let _e2257 = (_e2253 - select(0i, 1i, (_e2246 < f32(_e2253))));
let _e2259 = select(-1f, _e464, (_e464 > -1f));
let _e2261 = select(_e459, _e2259, (_e2259 < _e459));
let _e2268 = select(0i, select(select(i32(_e2261), i32(-2147483648), (_e2261 < -2147483600f)), 2147483647i, (_e2261 > 2147483500f)), (_e2261 == _e2261));
let _e2272 = (_e2268 - select(0i, 1i, (_e2261 < f32(_e2268))));
let _e2274 = select(-1f, _e474, (_e474 > -1f));
let _e2276 = select(_e469, _e2274, (_e2274 < _e469));
let _e2283 = select(0i, select(select(i32(_e2276), i32(-2147483648), (_e2276 < -2147483600f)), 2147483647i, (_e2276 > 2147483500f)), (_e2276 == _e2276));
let _e2287 = (_e2283 - select(0i, 1i, (_e2276 < f32(_e2283))));
let _e2291 = global_1.member.member_6.member_7;
let _e2295 = global_1.member.member_6.member_8;
let _e2303 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e2306 = (_e2272 + 1i);
let _e2316 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e2319 = (_e2287 + 1i);
let _e2328 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449));
let _e2329 = (_e2328 - 1i);
let _e2330 = (_e2257 - 1i);
let _e2332 = select(0i, _e2330, (_e2330 > 0i));
let _e2334 = select(0i, _e2257, (_e2257 > 0i));
let _e2335 = (_e2257 + 1i);
let _e2337 = select(_e2329, _e2335, (_e2335 < _e2329));
let _e2338 = (_e2257 + 2i);
let _e2341 = (_e2328 - 2i);
let _e2343 = select(0i, _e2341, (_e2341 > 0i));
let _e2345 = select(_e2343, _e2332, (_e2332 < _e2343));
let _e2347 = select(_e2343, _e2334, (_e2334 < _e2343));
let _e2349 = select(_e2343, _e2337, (_e2337 < _e2343));
let _e2368 = (select(0i, _e2272, (_e2272 > 0i)) * _e2291);
let _e2369 = (select(_e2303, _e2306, (_e2306 < _e2303)) * _e2291);
let _e2370 = (select(0i, _e2287, (_e2287 > 0i)) * _e2295);
let _e2371 = (select(_e2316, _e2319, (_e2319 < _e2316)) * _e2295);
local_2 = type_28(array<i32, 4>(_e2345, _e2347, _e2349, 0i), array<u32, 6>(bitcast<u32>(((_e2332 - _e2345) * 16i)), bitcast<u32>(((_e2334 - _e2345) * 16i)), bitcast<u32>(((_e2334 - _e2347) * 16i)), bitcast<u32>(((_e2337 - _e2347) * 16i)), bitcast<u32>(((_e2337 - _e2349) * 16i)), bitcast<u32>(((select(_e2329, _e2338, (_e2338 < _e2329)) - _e2349) * 16i))));
local_3 = vec3<f32>((_e454 - f32(_e2257)), (_e464 - f32(_e2272)), (_e474 - f32(_e2287)));
let _e2386 = local_2.member[1u];
let _e2387 = ((_e2370 + _e2368) + _e2386);
let _e2389 = (_e2387 >> bitcast<u32>(1i));
let _e2392 = bitcast<u32>(((_e2387 & 1i) * 16i));
let _e2394 = (bitcast<i32>(_e89) - 1i);
let _e2396 = select(_e2394, _e2389, (_e2389 < _e2394));
let _e2401 = global_2.member[bitcast<u32>(select(0i, _e2396, (_e2396 > 0i)))];
let _e2405 = (_e2389 + 1i);
let _e2407 = select(_e2394, _e2405, (_e2405 < _e2394));
let _e2412 = global_2.member[bitcast<u32>(select(0i, _e2407, (_e2407 > 0i)))];
let _e2419 = ((_e2401 >> bitcast<u32>((_e2392 & 31u))) | ((_e2412 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2392) & 31u))));
let _e2422 = local_2.member_1[2u];
let _e2428 = f32(bitcast<i32>(((_e2419 >> bitcast<u32>((_e2422 & 31u))) & 65535u)));
let _e2431 = local_2.member_1[3u];
let _e2438 = local_3[0u];
let _e2441 = (_e2428 + ((f32(bitcast<i32>(((_e2419 >> bitcast<u32>((_e2431 & 31u))) & 65535u))) - _e2428) * _e2438));
let _e2443 = local_2.member[1u];
let _e2444 = ((_e2370 + _e2369) + _e2443);
let _e2446 = (_e2444 >> bitcast<u32>(1i));
let _e2449 = bitcast<u32>(((_e2444 & 1i) * 16i));
let _e2451 = select(_e2394, _e2446, (_e2446 < _e2394));
let _e2456 = global_2.member[bitcast<u32>(select(0i, _e2451, (_e2451 > 0i)))];
let _e2460 = (_e2446 + 1i);
let _e2462 = select(_e2394, _e2460, (_e2460 < _e2394));
let _e2467 = global_2.member[bitcast<u32>(select(0i, _e2462, (_e2462 > 0i)))];
let _e2474 = ((_e2456 >> bitcast<u32>((_e2449 & 31u))) | ((_e2467 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2449) & 31u))));
let _e2475 = local_2.member_1[2u];
let _e2481 = f32(bitcast<i32>(((_e2474 >> bitcast<u32>((_e2475 & 31u))) & 65535u)));
let _e2482 = local_2.member_1[3u];
let _e2489 = local_3[0u];
let _e2494 = local_3[1u];
let _e2497 = (_e2441 + (((_e2481 + ((f32(bitcast<i32>(((_e2474 >> bitcast<u32>((_e2482 & 31u))) & 65535u))) - _e2481) * _e2489)) - _e2441) * _e2494));
let _e2499 = local_2.member[1u];
let _e2500 = ((_e2371 + _e2368) + _e2499);
let _e2502 = (_e2500 >> bitcast<u32>(1i));
let _e2505 = bitcast<u32>(((_e2500 & 1i) * 16i));
let _e2507 = select(_e2394, _e2502, (_e2502 < _e2394));
let _e2512 = global_2.member[bitcast<u32>(select(0i, _e2507, (_e2507 > 0i)))];
let _e2516 = (_e2502 + 1i);
let _e2518 = select(_e2394, _e2516, (_e2516 < _e2394));
let _e2523 = global_2.member[bitcast<u32>(select(0i, _e2518, (_e2518 > 0i)))];
let _e2530 = ((_e2512 >> bitcast<u32>((_e2505 & 31u))) | ((_e2523 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2505) & 31u))));
let _e2531 = local_2.member_1[2u];
let _e2537 = f32(bitcast<i32>(((_e2530 >> bitcast<u32>((_e2531 & 31u))) & 65535u)));
let _e2538 = local_2.member_1[3u];
let _e2545 = local_3[0u];
let _e2548 = (_e2537 + ((f32(bitcast<i32>(((_e2530 >> bitcast<u32>((_e2538 & 31u))) & 65535u))) - _e2537) * _e2545));
let _e2550 = local_2.member[1u];
let _e2551 = ((_e2371 + _e2369) + _e2550);
let _e2553 = (_e2551 >> bitcast<u32>(1i));
let _e2556 = bitcast<u32>(((_e2551 & 1i) * 16i));
let _e2558 = select(_e2394, _e2553, (_e2553 < _e2394));
let _e2563 = global_2.member[bitcast<u32>(select(0i, _e2558, (_e2558 > 0i)))];
let _e2567 = (_e2553 + 1i);
let _e2569 = select(_e2394, _e2567, (_e2567 < _e2394));
let _e2574 = global_2.member[bitcast<u32>(select(0i, _e2569, (_e2569 > 0i)))];
let _e2581 = ((_e2563 >> bitcast<u32>((_e2556 & 31u))) | ((_e2574 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2556) & 31u))));
let _e2582 = local_2.member_1[2u];
let _e2588 = f32(bitcast<i32>(((_e2581 >> bitcast<u32>((_e2582 & 31u))) & 65535u)));
let _e2589 = local_2.member_1[3u];
let _e2596 = local_3[0u];
let _e2600 = local_3[1u];
let _e2605 = local_3[2u];
let _e2612 = global_1.member.member_6.member_5;
let _e2617 = global_1.member.member_6.member_6;
let _e2618 = (((_e2497 + (((_e2548 + (((_e2588 + ((f32(bitcast<i32>(((_e2581 >> bitcast<u32>((_e2589 & 31u))) & 65535u))) - _e2588) * _e2596)) - _e2548) * _e2600)) - _e2497) * _e2605)) * _e2612) + _e2617);
let _e2620 = select(0f, _e2618, (_e2618 > 0f));
phi_4883_ = type_30(select(1f, _e2620, (_e2620 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2625 = phi_4883_;
let _e2627 = select(-0.5f, _e392, (_e392 > -0.5f));
let _e2629 = select(_e450, _e2627, (_e2627 < _e450));
let _e2631 = select(-0.5f, _e407, (_e407 > -0.5f));
let _e2633 = select(_e460, _e2631, (_e2631 < _e460));
let _e2635 = select(-0.5f, _e422, (_e422 > -0.5f));
let _e2637 = select(_e470, _e2635, (_e2635 < _e470));
let _e2639 = select(-1f, _e2629, (_e2629 > -1f));
let _e2641 = select(_e449, _e2639, (_e2639 < _e449));
let _e2648 = select(0i, select(select(i32(_e2641), i32(-2147483648), (_e2641 < -2147483600f)), 2147483647i, (_e2641 > 2147483500f)), (_e2641 == _e2641));
let _e2652 = (_e2648 - select(0i, 1i, (_e2641 < f32(_e2648))));
let _e2654 = select(-1f, _e2633, (_e2633 > -1f));
let _e2656 = select(_e459, _e2654, (_e2654 < _e459));
let _e2663 = select(0i, select(select(i32(_e2656), i32(-2147483648), (_e2656 < -2147483600f)), 2147483647i, (_e2656 > 2147483500f)), (_e2656 == _e2656));
let _e2667 = (_e2663 - select(0i, 1i, (_e2656 < f32(_e2663))));
let _e2669 = select(-1f, _e2637, (_e2637 > -1f));
let _e2671 = select(_e469, _e2669, (_e2669 < _e469));
let _e2678 = select(0i, select(select(i32(_e2671), i32(-2147483648), (_e2671 < -2147483600f)), 2147483647i, (_e2671 > 2147483500f)), (_e2671 == _e2671));
let _e2682 = (_e2678 - select(0i, 1i, (_e2671 < f32(_e2678))));
let _e2686 = global_1.member.member_6.member_7;
let _e2690 = global_1.member.member_6.member_8;
let _e2698 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e2701 = (_e2667 + 1i);
let _e2711 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e2714 = (_e2682 + 1i);
let _e2723 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449));
let _e2724 = (_e2723 - 1i);
let _e2725 = (_e2652 - 1i);
let _e2727 = select(0i, _e2725, (_e2725 > 0i));
let _e2729 = select(0i, _e2652, (_e2652 > 0i));
let _e2730 = (_e2652 + 1i);
let _e2732 = select(_e2724, _e2730, (_e2730 < _e2724));
let _e2733 = (_e2652 + 2i);
let _e2736 = (_e2723 - 2i);
let _e2738 = select(0i, _e2736, (_e2736 > 0i));
let _e2740 = select(_e2738, _e2727, (_e2727 < _e2738));
let _e2742 = select(_e2738, _e2729, (_e2729 < _e2738));
let _e2744 = select(_e2738, _e2732, (_e2732 < _e2738));
let _e2763 = (select(0i, _e2667, (_e2667 > 0i)) * _e2686);
let _e2764 = (select(_e2698, _e2701, (_e2701 < _e2698)) * _e2686);
let _e2765 = (select(0i, _e2682, (_e2682 > 0i)) * _e2690);
let _e2766 = (select(_e2711, _e2714, (_e2714 < _e2711)) * _e2690);
local = type_28(array<i32, 4>(_e2740, _e2742, _e2744, 0i), array<u32, 6>(bitcast<u32>(((_e2727 - _e2740) * 16i)), bitcast<u32>(((_e2729 - _e2740) * 16i)), bitcast<u32>(((_e2729 - _e2742) * 16i)), bitcast<u32>(((_e2732 - _e2742) * 16i)), bitcast<u32>(((_e2732 - _e2744) * 16i)), bitcast<u32>(((select(_e2724, _e2733, (_e2733 < _e2724)) - _e2744) * 16i))));
local_1 = vec3<f32>((_e2629 - f32(_e2652)), (_e2633 - f32(_e2667)), (_e2637 - f32(_e2682)));
let _e2781 = local.member[1u];
let _e2782 = ((_e2765 + _e2763) + _e2781);
let _e2784 = (_e2782 >> bitcast<u32>(1i));
let _e2787 = bitcast<u32>(((_e2782 & 1i) * 16i));
let _e2789 = (bitcast<i32>(_e89) - 1i);
let _e2791 = select(_e2789, _e2784, (_e2784 < _e2789));
let _e2796 = global_2.member[bitcast<u32>(select(0i, _e2791, (_e2791 > 0i)))];
let _e2800 = (_e2784 + 1i);
let _e2802 = select(_e2789, _e2800, (_e2800 < _e2789));
let _e2807 = global_2.member[bitcast<u32>(select(0i, _e2802, (_e2802 > 0i)))];
let _e2814 = ((_e2796 >> bitcast<u32>((_e2787 & 31u))) | ((_e2807 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2787) & 31u))));
let _e2817 = local.member_1[2u];
let _e2823 = f32(bitcast<i32>(((_e2814 >> bitcast<u32>((_e2817 & 31u))) & 65535u)));
let _e2826 = local.member_1[3u];
let _e2833 = local_1[0u];
let _e2836 = (_e2823 + ((f32(bitcast<i32>(((_e2814 >> bitcast<u32>((_e2826 & 31u))) & 65535u))) - _e2823) * _e2833));
let _e2838 = local.member[1u];
let _e2839 = ((_e2765 + _e2764) + _e2838);
let _e2841 = (_e2839 >> bitcast<u32>(1i));
let _e2844 = bitcast<u32>(((_e2839 & 1i) * 16i));
let _e2846 = select(_e2789, _e2841, (_e2841 < _e2789));
let _e2851 = global_2.member[bitcast<u32>(select(0i, _e2846, (_e2846 > 0i)))];
let _e2855 = (_e2841 + 1i);
let _e2857 = select(_e2789, _e2855, (_e2855 < _e2789));
let _e2862 = global_2.member[bitcast<u32>(select(0i, _e2857, (_e2857 > 0i)))];
let _e2869 = ((_e2851 >> bitcast<u32>((_e2844 & 31u))) | ((_e2862 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2844) & 31u))));
let _e2870 = local.member_1[2u];
let _e2876 = f32(bitcast<i32>(((_e2869 >> bitcast<u32>((_e2870 & 31u))) & 65535u)));
let _e2877 = local.member_1[3u];
let _e2884 = local_1[0u];
let _e2889 = local_1[1u];
let _e2892 = (_e2836 + (((_e2876 + ((f32(bitcast<i32>(((_e2869 >> bitcast<u32>((_e2877 & 31u))) & 65535u))) - _e2876) * _e2884)) - _e2836) * _e2889));
let _e2894 = local.member[1u];
let _e2895 = ((_e2766 + _e2763) + _e2894);
let _e2897 = (_e2895 >> bitcast<u32>(1i));
let _e2900 = bitcast<u32>(((_e2895 & 1i) * 16i));
let _e2902 = select(_e2789, _e2897, (_e2897 < _e2789));
let _e2907 = global_2.member[bitcast<u32>(select(0i, _e2902, (_e2902 > 0i)))];
let _e2911 = (_e2897 + 1i);
let _e2913 = select(_e2789, _e2911, (_e2911 < _e2789));
let _e2918 = global_2.member[bitcast<u32>(select(0i, _e2913, (_e2913 > 0i)))];
let _e2925 = ((_e2907 >> bitcast<u32>((_e2900 & 31u))) | ((_e2918 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2900) & 31u))));
let _e2926 = local.member_1[2u];
let _e2932 = f32(bitcast<i32>(((_e2925 >> bitcast<u32>((_e2926 & 31u))) & 65535u)));
let _e2933 = local.member_1[3u];
let _e2940 = local_1[0u];
let _e2943 = (_e2932 + ((f32(bitcast<i32>(((_e2925 >> bitcast<u32>((_e2933 & 31u))) & 65535u))) - _e2932) * _e2940));
let _e2945 = local.member[1u];
let _e2946 = ((_e2766 + _e2764) + _e2945);
let _e2948 = (_e2946 >> bitcast<u32>(1i));
let _e2951 = bitcast<u32>(((_e2946 & 1i) * 16i));
let _e2953 = select(_e2789, _e2948, (_e2948 < _e2789));
let _e2958 = global_2.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2962 = (_e2948 + 1i);
let _e2964 = select(_e2789, _e2962, (_e2962 < _e2789));
let _e2969 = global_2.member[bitcast<u32>(select(0i, _e2964, (_e2964 > 0i)))];
let _e2976 = ((_e2958 >> bitcast<u32>((_e2951 & 31u))) | ((_e2969 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2951) & 31u))));
let _e2977 = local.member_1[2u];
let _e2983 = f32(bitcast<i32>(((_e2976 >> bitcast<u32>((_e2977 & 31u))) & 65535u)));
let _e2984 = local.member_1[3u];
let _e2991 = local_1[0u];
let _e2995 = local_1[1u];
let _e3000 = local_1[2u];
let _e3007 = global_1.member.member_6.member_5;
let _e3012 = global_1.member.member_6.member_6;
let _e3013 = (((_e2892 + (((_e2943 + (((_e2983 + ((f32(bitcast<i32>(((_e2976 >> bitcast<u32>((_e2984 & 31u))) & 65535u))) - _e2983) * _e2991)) - _e2943) * _e2995)) - _e2892) * _e3000)) * _e3007) + _e3012);
let _e3015 = select(0f, _e3013, (_e3013 > 0f));
if ((_e608 & 16u) == 0u) {
phi_5884_ = type_5(1f, 1f, 1f);
} else {
let _e3023 = global_1.member.member_14.member;
let _e3034 = ((((_e3023.member.member * _e303) + (_e3023.member.member_1 * _e312)) + (_e3023.member.member_2 * _e285)) + _e3023.member_1);
let _e3040 = ((((_e3023.member.member * _e324) + (_e3023.member.member_1 * _e329)) + (_e3023.member.member_2 * _e318)) + _e3023.member_1);
let _e3042 = select(_e3040, _e3034, (_e3034 < _e3040));
let _e3044 = select(_e3040, _e3034, (_e3034 > _e3040));
let _e3046 = (_e3044 - _e3042);
let _e3049 = (-(_e3042) / select(1e-30f, _e3046, (_e3046 > 1e-30f)));
let _e3051 = select(0f, _e3049, (_e3049 > 0f));
let _e3057 = select(select(select(1f, _e3051, (_e3051 < 1f)), 1f, (_e3044 <= 0f)), 0f, (_e3042 > 0f));
let _e3062 = global_1.member.member_14.member_1;
let _e3063 = (_e3062 != 0u);
let _e3073 = global_1.member.member_15.member;
let _e3084 = ((((_e3073.member.member * _e303) + (_e3073.member.member_1 * _e312)) + (_e3073.member.member_2 * _e285)) + _e3073.member_1);
let _e3090 = ((((_e3073.member.member * _e324) + (_e3073.member.member_1 * _e329)) + (_e3073.member.member_2 * _e318)) + _e3073.member_1);
let _e3092 = select(_e3090, _e3084, (_e3084 < _e3090));
let _e3094 = select(_e3090, _e3084, (_e3084 > _e3090));
let _e3096 = (_e3094 - _e3092);
let _e3099 = (-(_e3092) / select(1e-30f, _e3096, (_e3096 > 1e-30f)));
let _e3101 = select(0f, _e3099, (_e3099 > 0f));
let _e3107 = select(select(select(1f, _e3101, (_e3101 < 1f)), 1f, (_e3094 <= 0f)), 0f, (_e3092 > 0f));
let _e3112 = global_1.member.member_15.member_1;
let _e3113 = (_e3112 != 0u);
let _e3123 = global_1.member.member_16.member;
let _e3134 = ((((_e3123.member.member * _e303) + (_e3123.member.member_1 * _e312)) + (_e3123.member.member_2 * _e285)) + _e3123.member_1);
let _e3140 = ((((_e3123.member.member * _e324) + (_e3123.member.member_1 * _e329)) + (_e3123.member.member_2 * _e318)) + _e3123.member_1);
let _e3142 = select(_e3140, _e3134, (_e3134 < _e3140));
let _e3144 = select(_e3140, _e3134, (_e3134 > _e3140));
let _e3146 = (_e3144 - _e3142);
let _e3149 = (-(_e3142) / select(1e-30f, _e3146, (_e3146 > 1e-30f)));
let _e3151 = select(0f, _e3149, (_e3149 > 0f));
let _e3157 = select(select(select(1f, _e3151, (_e3151 < 1f)), 1f, (_e3144 <= 0f)), 0f, (_e3142 > 0f));
let _e3162 = global_1.member.member_16.member_1;
let _e3163 = (_e3162 != 0u);
let _e3173 = global_1.member.member_17.member;
let _e3184 = ((((_e3173.member.member * _e303) + (_e3173.member.member_1 * _e312)) + (_e3173.member.member_2 * _e285)) + _e3173.member_1);
let _e3190 = ((((_e3173.member.member * _e324) + (_e3173.member.member_1 * _e329)) + (_e3173.member.member_2 * _e318)) + _e3173.member_1);
let _e3192 = select(_e3190, _e3184, (_e3184 < _e3190));
let _e3194 = select(_e3190, _e3184, (_e3184 > _e3190));
let _e3196 = (_e3194 - _e3192);
let _e3199 = (-(_e3192) / select(1e-30f, _e3196, (_e3196 > 1e-30f)));
let _e3201 = select(0f, _e3199, (_e3199 > 0f));
let _e3207 = select(select(select(1f, _e3201, (_e3201 < 1f)), 1f, (_e3194 <= 0f)), 0f, (_e3192 > 0f));
let _e3212 = global_1.member.member_17.member_1;
let _e3213 = (_e3212 != 0u);
phi_5884_ = type_5(((((1f * _e3057) * _e3107) * _e3157) * _e3207), ((((1f * select(1f, _e3057, _e3063)) * select(1f, _e3107, _e3113)) * select(1f, _e3157, _e3163)) * select(1f, _e3207, _e3213)), ((((1f * select(1f, 0f, (_e3063 && (_e3040 > 0f)))) * select(1f, 0f, (_e3113 && (_e3090 > 0f)))) * select(1f, 0f, (_e3163 && (_e3140 > 0f)))) * select(1f, 0f, (_e3213 && (_e3190 > 0f)))));
}
let _e3222 = phi_5884_;
let _e3223 = (_e324 - _e303);
let _e3224 = (_e329 - _e312);
let _e3225 = (_e318 - _e285);
let _e3230 = (((_e3223 * _e3223) + (_e3224 * _e3224)) + (_e3225 * _e3225));
let _e3234 = (_e480 < 1e-12f);
let _e3236 = (1f / select(_e475, 1f, _e3234));
let _e3238 = ((-0.5f - _e392) * _e3236);
let _e3240 = ((_e450 - _e392) * _e3236);
let _e3246 = select(_e3240, _e3238, (_e3238 < _e3240));
let _e3248 = select(0f, _e3246, (_e3246 > 0f));
let _e3251 = select(select(1f, _e3248, (_e3248 < 1f)), select(2f, 0f, ((_e392 >= -0.5f) && (_e392 <= _e450))), _e3234);
let _e3253 = select(_e3240, _e3238, (_e3238 > _e3240));
let _e3255 = select(0f, _e3253, (_e3253 > 0f));
let _e3258 = select(select(1f, _e3255, (_e3255 < 1f)), 1f, _e3234);
let _e3259 = (_e483 < 1e-12f);
let _e3261 = (1f / select(_e476, 1f, _e3259));
let _e3263 = ((-0.5f - _e407) * _e3261);
let _e3265 = ((_e460 - _e407) * _e3261);
let _e3271 = select(_e3265, _e3263, (_e3263 < _e3265));
let _e3273 = select(0f, _e3271, (_e3271 > 0f));
let _e3276 = select(select(1f, _e3273, (_e3273 < 1f)), select(2f, 0f, ((_e407 >= -0.5f) && (_e407 <= _e460))), _e3259);
let _e3278 = select(_e3265, _e3263, (_e3263 > _e3265));
let _e3280 = select(0f, _e3278, (_e3278 > 0f));
let _e3283 = select(select(1f, _e3280, (_e3280 < 1f)), 1f, _e3259);
let _e3284 = (_e488 < 1e-12f);
let _e3286 = (1f / select(_e477, 1f, _e3284));
let _e3288 = ((-0.5f - _e422) * _e3286);
let _e3290 = ((_e470 - _e422) * _e3286);
let _e3296 = select(_e3290, _e3288, (_e3288 < _e3290));
let _e3298 = select(0f, _e3296, (_e3296 > 0f));
let _e3301 = select(select(1f, _e3298, (_e3298 < 1f)), select(2f, 0f, ((_e422 >= -0.5f) && (_e422 <= _e470))), _e3284);
let _e3303 = select(_e3290, _e3288, (_e3288 > _e3290));
let _e3305 = select(0f, _e3303, (_e3303 > 0f));
let _e3308 = select(select(1f, _e3305, (_e3305 < 1f)), 1f, _e3284);
let _e3310 = select(_e3283, _e3258, (_e3258 < _e3283));
let _e3314 = select(_e3276, _e3251, (_e3251 > _e3276));
let _e3317 = (select(_e3308, _e3310, (_e3310 < _e3308)) - select(_e3301, _e3314, (_e3314 > _e3301)));
let _e3324 = global_1.member.member_5.member_3;
let _e3325 = ((sqrt(select(0f, _e3230, (_e3230 > 0f))) * select(0f, _e3317, (_e3317 > 0f))) * _e3324);
let _e3327 = (select(1f, _e3015, (_e3015 < 1f)) * 255f);
let _e3328 = (_e2625.member * 255f);
let _e3329 = (255f - 1f);
let _e3331 = select(0f, _e3327, (_e3327 > 0f));
let _e3333 = select(_e3329, _e3331, (_e3331 < _e3329));
let _e3340 = select(0i, select(select(i32(_e3333), i32(-2147483648), (_e3333 < -2147483600f)), 2147483647i, (_e3333 > 2147483500f)), (_e3333 == _e3333));
let _e3344 = (_e3340 - select(0i, 1i, (_e3333 < f32(_e3340))));
let _e3346 = select(0f, _e3328, (_e3328 > 0f));
let _e3348 = select(_e3329, _e3346, (_e3346 < _e3329));
let _e3355 = select(0i, select(select(i32(_e3348), i32(-2147483648), (_e3348 < -2147483600f)), 2147483647i, (_e3348 > 2147483500f)), (_e3348 == _e3348));
let _e3359 = (_e3355 - select(0i, 1i, (_e3348 < f32(_e3355))));
let _e3362 = (((_e3344 * 256i) + _e3359) * 4i);
let _e3364 = (_e3327 - f32(_e3344));
let _e3366 = (_e3328 - f32(_e3359));
let _e3368 = (bitcast<i32>(_e93) - 1i);
let _e3370 = select(_e3368, _e3362, (_e3362 < _e3368));
let _e3376 = global_4.member[bitcast<u32>(select(0i, _e3370, (_e3370 > 0i)))];
let _e3377 = (_e3362 + 4i);
let _e3379 = select(_e3368, _e3377, (_e3377 < _e3368));
let _e3385 = global_4.member[bitcast<u32>(select(0i, _e3379, (_e3379 > 0i)))];
let _e3386 = (_e3362 + 1024i);
let _e3388 = select(_e3368, _e3386, (_e3386 < _e3368));
let _e3394 = global_4.member[bitcast<u32>(select(0i, _e3388, (_e3388 > 0i)))];
let _e3395 = (_e3362 + 1028i);
let _e3397 = select(_e3368, _e3395, (_e3395 < _e3368));
let _e3403 = global_4.member[bitcast<u32>(select(0i, _e3397, (_e3397 > 0i)))];
let _e3408 = (bitcast<f32>(((_e3376 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3416 = (_e3408 + (((bitcast<f32>(((_e3385 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3408) * _e3366));
let _e3421 = (bitcast<f32>(((_e3394 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3445 = (bitcast<f32>((((_e3376 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3453 = (_e3445 + (((bitcast<f32>((((_e3385 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3445) * _e3366));
let _e3458 = (bitcast<f32>((((_e3394 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3470 = (_e3362 + 1i);
let _e3472 = select(_e3368, _e3470, (_e3470 < _e3368));
let _e3478 = global_4.member[bitcast<u32>(select(0i, _e3472, (_e3472 > 0i)))];
let _e3479 = (_e3362 + 5i);
let _e3481 = select(_e3368, _e3479, (_e3479 < _e3368));
let _e3487 = global_4.member[bitcast<u32>(select(0i, _e3481, (_e3481 > 0i)))];
let _e3488 = (_e3362 + 1025i);
let _e3490 = select(_e3368, _e3488, (_e3488 < _e3368));
let _e3496 = global_4.member[bitcast<u32>(select(0i, _e3490, (_e3490 > 0i)))];
let _e3497 = (_e3362 + 1029i);
let _e3499 = select(_e3368, _e3497, (_e3497 < _e3368));
let _e3505 = global_4.member[bitcast<u32>(select(0i, _e3499, (_e3499 > 0i)))];
let _e3510 = (bitcast<f32>(((_e3478 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3518 = (_e3510 + (((bitcast<f32>(((_e3487 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3510) * _e3366));
let _e3523 = (bitcast<f32>(((_e3496 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3547 = (bitcast<f32>((((_e3478 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3555 = (_e3547 + (((bitcast<f32>((((_e3487 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3547) * _e3366));
let _e3560 = (bitcast<f32>((((_e3496 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3575 = (_e3325 * _e3222.member_1);
let _e3577 = -(((_e3453 + (((_e3458 + (((bitcast<f32>((((_e3403 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3458) * _e3366)) - _e3453) * _e3364)) * _e3575));
let _e3579 = select(-87f, _e3577, (_e3577 > -87f));
let _e3581 = select(88f, _e3579, (_e3579 < 88f));
let _e3583 = ((_e3581 * 1.442695f) + 0.5f);
let _e3585 = select(-127f, _e3583, (_e3583 > -127f));
let _e3587 = select(128f, _e3585, (_e3585 < 128f));
let _e3594 = select(0i, select(select(i32(_e3587), i32(-2147483648), (_e3587 < -2147483600f)), 2147483647i, (_e3587 > 2147483500f)), (_e3587 == _e3587));
let _e3598 = (_e3594 - select(0i, 1i, (_e3587 < f32(_e3594))));
let _e3599 = f32(_e3598);
let _e3603 = ((_e3581 - (_e3599 * 0.6933594f)) - (_e3599 * -2.1219444e-4f));
let _e3625 = -(((_e3518 + (((_e3523 + (((bitcast<f32>(((_e3505 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3523) * _e3366)) - _e3518) * _e3364)) * _e3575));
let _e3627 = select(-87f, _e3625, (_e3625 > -87f));
let _e3629 = select(88f, _e3627, (_e3627 < 88f));
let _e3631 = ((_e3629 * 1.442695f) + 0.5f);
let _e3633 = select(-127f, _e3631, (_e3631 > -127f));
let _e3635 = select(128f, _e3633, (_e3633 < 128f));
let _e3642 = select(0i, select(select(i32(_e3635), i32(-2147483648), (_e3635 < -2147483600f)), 2147483647i, (_e3635 > 2147483500f)), (_e3635 == _e3635));
let _e3646 = (_e3642 - select(0i, 1i, (_e3635 < f32(_e3642))));
let _e3647 = f32(_e3646);
let _e3651 = ((_e3629 - (_e3647 * 0.6933594f)) - (_e3647 * -2.1219444e-4f));
let _e3673 = -(((_e3555 + (((_e3560 + (((bitcast<f32>((((_e3505 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3560) * _e3366)) - _e3555) * _e3364)) * _e3575));
let _e3675 = select(-87f, _e3673, (_e3673 > -87f));
let _e3677 = select(88f, _e3675, (_e3675 < 88f));
let _e3679 = ((_e3677 * 1.442695f) + 0.5f);
let _e3681 = select(-127f, _e3679, (_e3679 > -127f));
let _e3683 = select(128f, _e3681, (_e3681 < 128f));
let _e3690 = select(0i, select(select(i32(_e3683), i32(-2147483648), (_e3683 < -2147483600f)), 2147483647i, (_e3683 > 2147483500f)), (_e3683 == _e3683));
let _e3694 = (_e3690 - select(0i, 1i, (_e3683 < f32(_e3690))));
let _e3695 = f32(_e3694);
let _e3699 = ((_e3677 - (_e3695 * 0.6933594f)) - (_e3695 * -2.1219444e-4f));
let _e3721 = -(((_e3416 + (((_e3421 + (((bitcast<f32>(((_e3403 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3421) * _e3366)) - _e3416) * _e3364)) * (_e3325 * _e3222.member)));
let _e3723 = select(-87f, _e3721, (_e3721 > -87f));
let _e3725 = select(88f, _e3723, (_e3723 < 88f));
let _e3727 = ((_e3725 * 1.442695f) + 0.5f);
let _e3729 = select(-127f, _e3727, (_e3727 > -127f));
let _e3731 = select(128f, _e3729, (_e3729 < 128f));
let _e3738 = select(0i, select(select(i32(_e3731), i32(-2147483648), (_e3731 < -2147483600f)), 2147483647i, (_e3731 > 2147483500f)), (_e3731 == _e3731));
let _e3742 = (_e3738 - select(0i, 1i, (_e3731 < f32(_e3738))));
let _e3743 = f32(_e3742);
let _e3747 = ((_e3725 - (_e3743 * 0.6933594f)) - (_e3743 * -2.1219444e-4f));
let _e3767 = ((1f + (_e3747 * (1f + (_e3747 * (0.5f + (_e3747 * (0.16666667f + (_e3747 * (0.041666668f + (_e3747 * (0.008333334f + (_e3747 * (0.001388889f + (_e3747 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3742 + 127i)) << bitcast<u32>(23i))));
if _e625 {
let _e3782 = global_1.member.member_5.member_4;
let _e3785 = (_e2625.member_3.x * _e3222.member_2);
let _e3787 = (_e2625.member_3.y * _e3222.member_2);
let _e3789 = (_e2625.member_3.z * _e3222.member_2);
let _e3790 = (0.5f * (_e242 / _e194));
let _e3794 = (_e172 + (_e3785 * _e3790));
let _e3795 = (_e183 + (_e3787 * _e3790));
let _e3796 = (_e194 + (_e3789 * _e3790));
let _e3798 = (2f * _e242);
let _e3800 = ((_e3796 * _e3796) + (_e3798 * _e3789));
let _e3804 = (_e3796 + sqrt(select(0f, _e3800, (_e3800 > 0f))));
let _e3808 = (0.5f * (_e3798 / select(1e-6f, _e3804, (_e3804 > 1e-6f))));
let _e3812 = (_e3794 + (_e3785 * _e3808));
let _e3813 = (_e3795 + (_e3787 * _e3808));
let _e3814 = (_e3796 + (_e3789 * _e3808));
let _e3818 = (_e3782 * _e3782);
let _e3820 = (_e3814 * _e3814);
let _e3828 = (((_e3796 <= 0f) || (_e3800 <= 0f)) || ((_e3814 <= 0f) || (_e3820 <= (_e3818 * (((_e3812 * _e3812) + (_e3813 * _e3813)) + _e3820)))));
let _e3842 = (_e172 + ((_e2625.member_4.x * _e3222.member_2) * _e242));
let _e3843 = (_e183 + ((_e2625.member_4.y * _e3222.member_2) * _e242));
let _e3844 = (_e194 + ((_e2625.member_4.z * _e3222.member_2) * _e242));
let _e3846 = (_e3844 * _e3844);
let _e3855 = ((_e608 & 1u) != 0u);
phi_6908_ = select(select(select(_e3814, _e3796, _e3828), _e3844, _e3855), _e194, _e615);
phi_6909_ = select(select(select(_e3813, _e3795, _e3828), _e3843, _e3855), _e183, _e615);
phi_6910_ = select(select(select(_e3812, _e3794, _e3828), _e3842, _e3855), _e172, _e615);
phi_6911_ = (select(_e3828, ((_e3844 <= 0f) || (_e3846 <= (_e3818 * (((_e3842 * _e3842) + (_e3843 * _e3843)) + _e3846)))), _e3855) && !(_e615));
} else {
phi_6908_ = _e194;
phi_6909_ = _e183;
phi_6910_ = _e172;
phi_6911_ = false;
}
let _e3866 = phi_6908_;
let _e3868 = phi_6909_;
let _e3870 = phi_6910_;
let _e3872 = phi_6911_;
global_6.member[_e118] = (_e129 + _e257);
global_6.member[_e130] = (_e139 + _e264);
global_6.member[_e141] = (_e150 + _e366);
global_6.member[_e152] = (_e161 + _e369);
global_6.member[_e163] = _e3870;
global_6.member[_e174] = _e3868;
global_6.member[_e185] = _e3866;
global_6.member[_e196] = select((_e205 * (((1f + (_e3603 * (1f + (_e3603 * (0.5f + (_e3603 * (0.16666667f + (_e3603 * (0.041666668f + (_e3603 * (0.008333334f + (_e3603 * (0.001388889f + (_e3603 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3598 + 127i)) << bitcast<u32>(23i)))) * _e3767)), _e205, _e615);
global_6.member[_e207] = select((_e216 * (((1f + (_e3651 * (1f + (_e3651 * (0.5f + (_e3651 * (0.16666667f + (_e3651 * (0.041666668f + (_e3651 * (0.008333334f + (_e3651 * (0.001388889f + (_e3651 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3646 + 127i)) << bitcast<u32>(23i)))) * _e3767)), _e216, _e615);
global_6.member[_e218] = select((_e227 * (((1f + (_e3699 * (1f + (_e3699 * (0.5f + (_e3699 * (0.16666667f + (_e3699 * (0.041666668f + (_e3699 * (0.008333334f + (_e3699 * (0.001388889f + (_e3699 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3694 + 127i)) << bitcast<u32>(23i)))) * _e3767)), _e227, _e615);
global_6.member[_e229] = select(_e238, 1f, _e3872);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
